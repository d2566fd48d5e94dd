#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "scenes/rooms/backgrounds.h"
#include "scenes/rooms/furniture.h"
#include "scenes/shapes/solids.h"

namespace seamline::scenes {
namespace furnished_room_parts {
namespace {

using Vector3d = Eigen::Vector3d;
using std::numbers::pi;

constexpr double back_z_m = -7.0;
constexpr double front_z_m = 1.6;
constexpr double right_x_m = 4.2;
constexpr double left_x_m = -4.2;
constexpr double height_m = 3.0;
constexpr double sun_elevation_rad = 24 * pi / 180;

/// A room that is being furnished.
struct Furnishing {
  SceneContents room;
  Random random{20240607};
  int placed = 0;  ///< pieces so far, for names

  void put(const std::string& kind, const TriangleMesh& mesh, const Vector3d& at_m, double yaw_deg = 0) {
    const Eigen::Affine3d placement =
        Eigen::Translation3d(at_m) * Eigen::AngleAxisd(yaw_deg * pi / 180, Vector3d::UnitY());
    room.parts.push_back({kind + "_" + std::to_string(++placed), transformed(mesh, placement)});
  }
  /// A number around 0, for what people do not place exactly.
  double about(double spread) { return spread * (2 * random.uniform() - 1); }
};

/// Closed but for the left side, where only two posts and a beam stand.
void add_shell(SceneContents& room) {
  const auto add = [&](const std::string& name, const TriangleMesh& mesh) {
    room.parts.push_back({name, mesh});
  };
  add("floor", box({left_x_m, -0.1, back_z_m}, {right_x_m, 0, front_z_m}));
  add("ceiling", box({left_x_m, height_m, back_z_m}, {right_x_m, height_m + 0.1, front_z_m}));
  add("wall_back", box({left_x_m, 0, back_z_m - 0.1}, {right_x_m, height_m, back_z_m}));
  add("wall_right", box({right_x_m, 0, back_z_m}, {right_x_m + 0.1, height_m, front_z_m}));
  add("wall_front", box({left_x_m, 0, front_z_m}, {right_x_m, height_m, front_z_m + 0.1}));
  TriangleMesh frame = box({left_x_m - 0.1, height_m - 0.15, back_z_m}, {left_x_m, height_m, front_z_m});
  for (const double z : {-4.2, -1.3})
    append(frame, box({left_x_m - 0.1, 0, z}, {left_x_m, height_m - 0.15, z + 0.1}));
  add("frame_left", frame);
}

void add_dining_corner(Furnishing& f) {
  constexpr double x = 2.3, z = -5.2, table_m = 0.75;
  f.put("table", make_table(1.7, 0.95, table_m), {x, 0, z});
  for (int i = 0; i < 3; ++i) {
    f.put("chair", make_chair(), {x + 0.55 * (i - 1) + f.about(0.04), 0, z + 0.62 + f.about(0.05)},
          180 + f.about(12));
    f.put("chair", make_chair(), {x + 0.55 * (i - 1) + f.about(0.04), 0, z - 0.62 + f.about(0.05)},
          f.about(12));
    f.put("dish", make_dish(0.13, 0.03), {x + 0.55 * (i - 1), table_m, z + 0.3});
    f.put("dish", make_dish(0.13, 0.03), {x + 0.55 * (i - 1), table_m, z - 0.3});
    f.put("hanging_lamp", make_hanging_lamp(1.25), {x + 0.55 * (i - 1), height_m, z});
  }
  f.put("bowl", make_dish(0.2, 0.11), {x + 0.1, table_m, z});
  f.put("vase", make_vase(0.28), {x - 0.4, table_m, z + 0.02});
}

void add_sitting_corner(Furnishing& f) {
  f.put("sofa", make_sofa(3), {-2.0, 0, back_z_m + 0.5});
  f.put("armchair", make_sofa(1), {-3.5, 0, -5.1}, 70);
  f.put("armchair", make_sofa(1), {-0.3, 0, -5.55}, -60);
  f.put("coffee_table", make_table(1.0, 0.55, 0.42), {-2.0, 0, -5.45});
  f.put("bowl", make_dish(0.16, 0.08), {-1.8, 0.42, -5.4});
  f.put("vase", make_vase(0.22), {-2.3, 0.42, -5.5});
  f.put("rug", box({-1.5, 0, -0.9}, {1.5, 0.012, 0.9}), {-2.0, 0, -5.3}, 2);
  f.put("lamp", make_lamp(1.65, 0.24), {-3.75, 0, back_z_m + 0.45});
  f.put("lamp", make_lamp(1.55, 0.2), {-0.2, 0, back_z_m + 0.4});
  f.put("stool", make_stool(), {-3.3, 0, -3.9});
  f.put("stool", make_stool(), {-2.6, 0, -3.4});
}

/// Two cases, each board with its books.
void add_bookcases(Furnishing& f) {
  constexpr int boards = 6;
  constexpr double case_m = 2.1, width_m = 0.95;
  for (int i = 0; i < 2; ++i) {
    const Vector3d at(right_x_m - 0.17, 0, -3.3 + 1.05 * i);
    f.put("bookcase", make_bookcase(width_m, case_m, boards), at, -90);
    for (int board = 0; board + 1 < boards; ++board)
      f.put("books", make_books((width_m - 0.08) * (0.6 + 0.4 * f.random.uniform()), f.random),
            at + Vector3d(0, (case_m - 0.03) * board / (boards - 1) + 0.03, 0), -90);
  }
}

void add_back_wall(Furnishing& f) {
  f.put("sideboard", make_sideboard(1.6, 4), {2.3, 0, back_z_m + 0.24});
  f.put("table_lamp", make_lamp(0.5, 0.13), {1.7, 0.75, back_z_m + 0.24});
  f.put("books", make_books(0.4, f.random), {2.4, 0.75, back_z_m + 0.2});
  f.put("vase", make_vase(0.35), {2.9, 0.75, back_z_m + 0.24});
  f.put("clock",
        transformed(make_dish(0.2, 0.04), Eigen::Affine3d(Eigen::AngleAxisd(pi / 2, Vector3d::UnitX()))),
        {0.45, 2.1, back_z_m + 0.01});
  f.put("picture", make_picture(0.9, 0.6), {-2.6, 1.7, back_z_m});
  f.put("picture", make_picture(0.45, 0.6), {-1.5, 1.7, back_z_m});
  f.put("picture", make_picture(0.7, 0.5), {2.3, 1.8, back_z_m});
  f.put("curtain", make_curtain(1.2, 2.8), {left_x_m + 0.12, 0.02, back_z_m + 0.7}, 90);
  f.put("curtain", make_curtain(0.9, 2.8), {left_x_m + 0.12, 0.02, front_z_m - 0.5}, 90);
}

/// What stands about: plants, boxes, stools, a bench along the right wall.
void add_odds_and_ends(Furnishing& f) {
  f.put("plant", make_plant(1.3, f.random), {0.55, 0, back_z_m + 0.45});
  f.put("plant", make_plant(0.9, f.random), {3.75, 0, back_z_m + 0.5});
  f.put("plant", make_plant(1.1, f.random), {-3.7, 0, -2.9});
  f.put("picture", make_picture(0.6, 0.8), {right_x_m, 1.7, -5.2}, -90);
  f.put("bench", make_table(1.1, 0.35, 0.42), {3.85, 0, -1.2}, 90);
  f.put("stool", make_stool(), {2.6, 0, -3.1});
  for (int i = 0; i < 4; ++i) {
    const double size = 0.32 - 0.05 * i;
    f.put("box", box({-size / 2, 0, -size / 2}, {size / 2, 0.6 * size, size / 2}),
          {3.0 + f.about(0.03), i < 3 ? 0.6 * (0.32 * i - 0.025 * i * (i - 1)) : 0.0, i < 3 ? -2.2 : -1.7},
          f.about(25));
  }
  f.put("chair", make_chair(), {2.9, 0, -3.8}, -150);
  f.put("bowl", make_dish(0.14, 0.07), {-2.6, 0.5, -3.4});
}

}  // namespace
}  // namespace furnished_room_parts

SceneContents make_furnished_room() {
  using namespace furnished_room_parts;
  Furnishing f;
  add_shell(f.room);
  add_dining_corner(f);
  add_sitting_corner(f);
  add_bookcases(f);
  add_back_wall(f);
  add_odds_and_ends(f);
  // The horizontal field of view is 70 degrees.
  f.room.camera = SceneCamera{.position_m = {0, 1.6, 0.9},
                              .look_at_m = {0, 1.0, -5},
                              .vertical_fov_rad = 2 * std::atan(std::tan(35 * pi / 180) / camera_aspect)};
  const double azimuth_rad = 78 * pi / 180;  // from the open side, a little from the front
  f.room.sun =
      SceneSun{.to_sun = {-std::cos(sun_elevation_rad) * std::sin(azimuth_rad), std::sin(sun_elevation_rad),
                          std::cos(sun_elevation_rad) * std::cos(azimuth_rad)},
               .irradiance_w_m2 = 8.0};
  return f.room;
}

}  // namespace seamline::scenes
