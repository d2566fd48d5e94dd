#include <Eigen/Geometry>

#include "scenes/backgrounds.h"
#include "scenes/solids.h"

namespace seamline {
namespace {

using Vector3d = Eigen::Vector3d;

constexpr double back_z_m = -7.2;
constexpr double right_x_m = 3.7;
constexpr double left_x_m = -3.7;
constexpr double front_z_m = 2.0;
constexpr double wall_height_m = 3.6;

void add(SceneContents& room, const std::string& name, const std::vector<TriangleMesh>& pieces) {
  TriangleMesh whole;
  for (const TriangleMesh& piece : pieces) append(whole, piece);
  room.parts.push_back({name, whole});
}

/// A cuboid by its footprint's centre, where it stands, and its size.
TriangleMesh piece(double x_m, double z_m, double bottom_m, const Vector3d& size_m) {
  const Vector3d half(size_m.x() / 2, 0, size_m.z() / 2);
  const Vector3d base(x_m, bottom_m, z_m);
  return box(base - half, base + half + Vector3d(0, size_m.y(), 0));
}

void add_shell(SceneContents& room) {
  add(room, "floor", {box({left_x_m, -0.1, back_z_m}, {right_x_m, 0, front_z_m})});
  add(room, "wall_back", {box({left_x_m, 0, back_z_m - 0.1}, {right_x_m, wall_height_m, back_z_m})});
  add(room, "wall_right", {box({right_x_m, 0, back_z_m}, {right_x_m + 0.1, wall_height_m, front_z_m})});
  add(room, "wall_front", {box({left_x_m, 0, front_z_m}, {right_x_m, wall_height_m, front_z_m + 0.1})});
  add(room, "sill", {box({left_x_m - 0.15, 0, back_z_m}, {left_x_m, 0.12, front_z_m})});
  add(room, "skirting", {box({left_x_m, 0, back_z_m}, {right_x_m, 0.09, back_z_m + 0.02}),
                         box({right_x_m - 0.02, 0, back_z_m}, {right_x_m, 0.09, front_z_m})});
}

void add_bed(SceneContents& room) {
  const double x = 0.35;
  const double z = back_z_m + 1.12;
  add(room, "bed", {piece(x, z, 0.12, {1.9, 0.2, 2.1}), piece(x, z, 0.32, {1.84, 0.24, 2.04}),
                    piece(x - 0.87, z + 0.97, 0, {0.1, 0.14, 0.1}), piece(x + 0.87, z + 0.97, 0, {0.1, 0.14, 0.1}),
                    piece(x, z + 0.35, 0.54, {1.92, 0.06, 1.2})});
  add(room, "headboard", {piece(x, back_z_m + 0.06, 0.1, {2.0, 1.0, 0.08})});
  add(room, "pillow_left", {piece(x - 0.45, z - 0.72, 0.56, {0.68, 0.16, 0.42})});
  add(room, "pillow_right", {piece(x + 0.45, z - 0.72, 0.56, {0.68, 0.16, 0.42})});
}

TriangleMesh cabinet(double x, double z, const Vector3d& size) {
  TriangleMesh mesh = piece(x, z, 0, size);
  append(mesh, piece(x, z + size.z() / 2 + 0.01, 0.06, {size.x() * 0.92, size.y() * 0.4, 0.02}));
  append(mesh, piece(x, z + size.z() / 2 + 0.01, 0.1 + size.y() * 0.45, {size.x() * 0.92, size.y() * 0.4, 0.02}));
  return mesh;
}

void add_furniture(SceneContents& room) {
  add(room, "nightstand", {cabinet(1.75, back_z_m + 0.3, {0.5, 0.55, 0.45})});
  add(room, "wardrobe", {piece(-2.9, back_z_m + 0.35, 0, {1.3, 2.2, 0.6}), piece(-3.22, back_z_m + 0.66, 0.1, {0.6, 2.0, 0.03}),
                         piece(-2.58, back_z_m + 0.66, 0.1, {0.6, 2.0, 0.03})});
  add(room, "chest", {cabinet(3.1, -5.9, {0.9, 0.5, 1.0})});
  add(room, "shelf", {piece(2.9, back_z_m + 0.14, 1.5, {1.2, 0.04, 0.28}), piece(2.9, back_z_m + 0.14, 1.9, {1.2, 0.04, 0.28})});
  std::vector<TriangleMesh> books;
  for (int i = 0; i < 9; ++i)
    books.push_back(piece(2.4 + 0.09 * i, back_z_m + 0.12, 1.54, {0.06, 0.2 + 0.02 * (i * 5 % 4), 0.18}));
  add(room, "books", books);
  add(room, "stool", {piece(0, -4.95, 0.34, {0.95, 0.06, 0.6}), piece(-0.42, -4.95, 0, {0.06, 0.34, 0.54}),
                      piece(0.42, -4.95, 0, {0.06, 0.34, 0.54})});
}

}  // namespace

SceneContents make_bedroom() {
  SceneContents room;
  add_shell(room);
  add_bed(room);
  add_furniture(room);
  room.camera = SceneCamera{.position_m = {0, 1.6, 0}, .look_at_m = {0, 0.95, -5}, .vertical_fov_rad = 0.64};
  room.sun = SceneSun{.to_sun = Vector3d(-0.75, 0.42, 0.50).normalized(), .irradiance_w_m2 = 3.0};
  return room;
}

}  // namespace seamline
