#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "scenes/rooms/backgrounds.h"
#include "scenes/rooms/car.h"
#include "scenes/rooms/furniture.h"
#include "scenes/shapes/solids.h"

namespace seamline::scenes {
namespace loft_parts {
namespace {

using Vector3d = Eigen::Vector3d;
using Colour = std::array<double, 3>;
using std::numbers::pi;

constexpr double left_x_m = -5.0, right_x_m = 5.2, back_z_m = -7.2, front_z_m = 2.6, height_m = 3.5;
constexpr double sill_m = 0.55, lintel_m = 3.0;
/// Windows of the left wall, by where they begin; each is so wide.
constexpr std::array<double, 3> window_z_m = {-6.6, -3.6, -0.6};
constexpr double window_width_m = 2.4;

/// A loft that is being furnished.
struct Loft {
  SceneContents room;
  Random random{20261124};
  int placed = 0;  ///< pieces so far, for names

  void add(const std::string& name, const TriangleMesh& mesh, const Colour& albedo,
           const SceneSurface& surface = {}) {
    room.parts.push_back({name, mesh, albedo, surface});
  }
  void add_patterned(const std::string& name, const TriangleMesh& mesh, const std::string& pattern,
                     const Colour& tint = {1, 1, 1}) {
    room.parts.push_back(patterned({name, mesh, tint}, pattern));
  }
  /// A piece of furniture, its pattern in its own axes.
  void put(const std::string& kind, const TriangleMesh& mesh, const Vector3d& at_m, double yaw_deg,
           const Colour& albedo, const std::string& pattern = {}) {
    ScenePart part{kind + "_" + std::to_string(++placed), mesh, albedo};
    if (!pattern.empty()) part = patterned(part, pattern);
    part.mesh = transformed(
        part.mesh, Eigen::Translation3d(at_m) * Eigen::AngleAxisd(yaw_deg * pi / 180, Vector3d::UnitY()));
    room.parts.push_back(std::move(part));
  }
};

void add_shell(Loft& loft) {
  loft.add_patterned("floor", box({left_x_m, -0.1, back_z_m}, {right_x_m, 0, front_z_m}), "planks");
  loft.add_patterned("ceiling", box({left_x_m, height_m, back_z_m}, {right_x_m, height_m + 0.1, front_z_m}),
                     "plaster");
  loft.add_patterned("wall_back", box({left_x_m, 0, back_z_m - 0.1}, {right_x_m, height_m, back_z_m}),
                     "plaster");
  loft.add_patterned("wall_right", box({right_x_m, 0, back_z_m}, {right_x_m + 0.1, height_m, front_z_m}),
                     "concrete");
  loft.add_patterned("wall_front", box({left_x_m, 0, front_z_m}, {right_x_m, height_m, front_z_m + 0.1}),
                     "plaster");
  constexpr double out_m = 0.25;
  TriangleMesh wall = box({left_x_m - out_m, 0, back_z_m}, {left_x_m, sill_m, front_z_m});
  append(wall, box({left_x_m - out_m, lintel_m, back_z_m}, {left_x_m, height_m, front_z_m}));
  double from_m = back_z_m;
  for (const double z : window_z_m) {
    append(wall, box({left_x_m - out_m, sill_m, from_m}, {left_x_m, lintel_m, z}));
    from_m = z + window_width_m;
  }
  append(wall, box({left_x_m - out_m, sill_m, from_m}, {left_x_m, lintel_m, front_z_m}));
  loft.add_patterned("wall_left", wall, "plaster");
  TriangleMesh skirting = box({left_x_m, 0, back_z_m}, {right_x_m, 0.09, back_z_m + 0.018});
  append(skirting, box({left_x_m, 0, back_z_m}, {left_x_m + 0.018, 0.09, front_z_m}));
  append(skirting, box({right_x_m - 0.018, 0, back_z_m}, {right_x_m, 0.09, front_z_m}));
  loft.add("skirting", skirting, {0.75, 0.74, 0.72}, {.roughness = 0.4});
}

/// Bars of steel, and panes that glow where the windows are.
void add_windows(Loft& loft, bool with_panes) {
  TriangleMesh bars;
  constexpr double x_m = left_x_m - 0.14, thick_m = 0.05;
  int number = 0;
  for (const double z : window_z_m) {
    for (int column = 0; column <= 3; ++column) {
      const double at = z + window_width_m * column / 3;
      append(bars, box({x_m, sill_m, at - thick_m / 2}, {x_m + thick_m, lintel_m, at + thick_m / 2}));
    }
    for (const double y : {sill_m + 0.025, 1.6, lintel_m - 0.025})
      append(bars, box({x_m - 0.002, y - thick_m / 2, z},
                       {x_m + thick_m + 0.002, y + thick_m / 2, z + window_width_m}));
    if (with_panes)
      loft.add("pane_" + std::to_string(++number),
               polygon({{x_m, sill_m, z + window_width_m},
                        {x_m, sill_m, z},
                        {x_m, lintel_m, z},
                        {x_m, lintel_m, z + window_width_m}}),
               {0, 0, 0}, {.emission_w_m2_sr = {7.0, 7.6, 8.2}});
  }
  loft.add("window_bars", bars, {0.06, 0.06, 0.06}, {.roughness = 0.4, .metallic = 0});
}

void add_sitting_corner(Loft& loft) {
  loft.put("rug", box({-1.6, 0, -1.15}, {1.6, 0.014, 1.15}), {-2.1, 0, -3.9}, -2, {0.95, 0.32, 0.2},
           "plaster");
  loft.put("couch", make_sofa(3), {-2.1, 0, -5.2}, 8, {1, 1, 1}, "weave");
  loft.put("armchair", make_sofa(1), {-4.1, 0, -3.7}, 75, {1, 0.55, 0.3}, "weave");
  loft.put("coffee_table", make_table(1.1, 0.6, 0.4), {-2.1, 0, -3.75}, 4, {1, 1, 1}, "planks");
  loft.put("bowl", make_dish(0.15, 0.07), {-2.45, 0.4, -3.7}, 0, {0.55, 0.5, 0.42});
  loft.put("lamp", make_lamp(1.7, 0.24), {-4.2, 0, -6.4}, 0, {0.7, 0.66, 0.55});
  loft.put("plant", make_plant(1.5, loft.random), {-0.35, 0, -6.5}, 0, {0.1, 0.26, 0.07});
  loft.put("picture", make_picture(1.5, 0.9), {-2.2, 1.9, back_z_m}, 0, {0.5, 0.4, 0.22}, "concrete");
}

void add_back_and_right(Loft& loft) {
  loft.put("bookcase", make_bookcase(1.1, 2.2, 6), {1.3, 0, back_z_m + 0.18}, 0, {1, 1, 1}, "planks");
  const std::array<Colour, 5> spines = {
      {{0.4, 0.1, 0.08}, {0.12, 0.2, 0.36}, {0.5, 0.42, 0.28}, {0.1, 0.28, 0.16}, {0.32, 0.28, 0.3}}};
  for (int board = 0; board < 5; ++board)
    loft.put("books", make_books(0.75 + 0.2 * loft.random.uniform(), loft.random),
             {1.3, 2.17 * board / 5 + 0.03, back_z_m + 0.18}, 0, spines[static_cast<std::size_t>(board)]);
  loft.put("sideboard", make_sideboard(1.6, 4), {3.6, 0, back_z_m + 0.26}, 0, {1, 1, 1}, "planks");
  loft.put("vase", make_vase(0.36), {3.1, 0.75, back_z_m + 0.26}, 0, {0.6, 0.6, 0.58});
  loft.put("picture", make_picture(0.8, 0.6), {3.6, 1.8, back_z_m}, 0, {0.7, 0.7, 0.9}, "concrete");
  for (int i = 0; i < 3; ++i)
    loft.put("hanging_lamp", make_hanging_lamp(1.0), {-2.9 + 0.8 * i, height_m, -3.75}, 0, {0.1, 0.1, 0.1});
  loft.put("stool", make_stool(), {4.4, 0, -0.6}, 0, {1, 1, 1}, "planks");
}

void add_car(Loft& loft) {
  const Eigen::Affine3d place =
      Eigen::Translation3d(2.35, 0, -4.15) * Eigen::AngleAxisd(-140 * pi / 180, Vector3d::UnitY());
  for (ScenePart part : make_car()) {
    part.mesh = transformed(part.mesh, place);
    loft.room.parts.push_back(std::move(part));
  }
}

}  // namespace
}  // namespace loft_parts

SceneContents make_loft(LoftWindows windows) {
  using namespace loft_parts;
  Loft loft;
  add_shell(loft);
  add_windows(loft, windows == LoftWindows::glowing);
  add_sitting_corner(loft);
  add_back_and_right(loft);
  add_car(loft);
  loft.room.camera =
      SceneCamera{.position_m = {0, 1.5, 0}, .look_at_m = {0.1, 0.95, -4}, .vertical_fov_rad = 0.85};
  if (windows == LoftWindows::open)
    loft.room.lamp = SceneLamp{.position_m = {-1.2, 2.6, -2.4}, .intensity_w_sr = 4};
  return loft.room;
}

}  // namespace seamline::scenes
