#include <Eigen/Geometry>

#include "scenes/rooms/backgrounds.h"
#include "scenes/rooms/plans.h"
#include "scenes/shapes/solids.h"

namespace seamline::scenes {
namespace bedroom_parts {
namespace {

using Vector3d = Eigen::Vector3d;

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

struct RoomBuilder : RoomPlan {
  /// The left side is open from its stub of wall to the front; the sun comes in there.
  void add_shell(SceneContents& room) const {
    add(room, "floor", {box({left_x_m, -0.1, back_z_m}, {right_x_m, 0, front_z_m})});
    add(room, "wall_back", {box({left_x_m, 0, back_z_m - 0.1}, {right_x_m, wall_height_m, back_z_m})});
    add(room, "wall_right", {box({right_x_m, 0, back_z_m}, {right_x_m + 0.1, wall_height_m, front_z_m})});
    add(room, "wall_front", {box({left_x_m, 0, front_z_m}, {right_x_m, 2.6, front_z_m + 0.1})});
    add(room, "wall_left", {box({left_x_m - 0.1, 0, back_z_m}, {left_x_m, wall_height_m, back_z_m + 1.0})});
    add(room, "sill", {box({left_x_m - 0.15, 0, back_z_m + 1.0}, {left_x_m, 0.1, front_z_m})});
    add(room, "skirting",
        {box({left_x_m, 0, back_z_m}, {right_x_m, 0.09, back_z_m + 0.02}),
         box({right_x_m - 0.02, 0, back_z_m}, {right_x_m, 0.09, front_z_m})});
  }

  /// It stands lengthwise along the back wall, its head to the right.
  void add_bed(SceneContents& room) const {
    const double x = bed_x_m;
    const double z = back_z_m + 0.52;
    add(room, "bed",
        {piece(x, z, 0, {2.2, bed_height_m, 0.98}), piece(x - 0.3, z, bed_height_m, {1.6, 0.05, 1.0})});
    add(room, "headboard", {piece(x + 1.13, z, 0, {0.08, headboard_m, 1.02})});
    add(room, "pillow", {piece(x + 0.8, z - 0.08, bed_height_m, {0.42, 0.13, 0.6})});
  }

  void add_wardrobe(SceneContents& room) const {
    add(room, "wardrobe",
        {piece(wardrobe_x_m, back_z_m + 0.27, 0, {1.2, 2.25, 0.52}),
         piece(wardrobe_x_m - 0.3, back_z_m + 0.54, 0.1, {0.55, 2.05, 0.03}),
         piece(wardrobe_x_m + 0.3, back_z_m + 0.54, 0.1, {0.55, 2.05, 0.03}),
         piece(wardrobe_x_m, back_z_m + 0.27, 2.25, {1.3, 0.08, 0.58})});
  }

  void add_shelf(SceneContents& room) const {
    const double move_x = shelf_x_m - 0.35;
    add(room, "shelf",
        {piece(move_x + 0.35, back_z_m + 0.14, shelf_height_m, {1.5, 0.05, 0.28}),
         piece(move_x + 0.35, back_z_m + 0.14, shelf_height_m + 0.38, {1.5, 0.05, 0.28}),
         piece(move_x - 0.38, back_z_m + 0.14, shelf_height_m, {0.05, 0.43, 0.28}),
         piece(move_x + 1.08, back_z_m + 0.14, shelf_height_m, {0.05, 0.43, 0.28})});
    std::vector<TriangleMesh> row;
    for (int i = 0; i < books; ++i)
      row.push_back(piece(move_x - 0.28 + 0.085 * i, back_z_m + 0.12, shelf_height_m + 0.05,
                          {0.06, 0.2 + 0.02 * (i * 5 % 4), 0.19}));
    add(room, "books", row);
  }

  void add_furniture(SceneContents& room) const {
    add_bed(room);
    add_wardrobe(room);
    add(room, "chest", {piece(chest_x_m, back_z_m + 0.3, 0, {chest_width_m, chest_height_m, 0.6})});
    add_shelf(room);
    add(room, "stool",
        {piece(stool_x_m, stool_z_m, stool_height_m, {1.1, 0.06, 0.5}),
         piece(stool_x_m - 0.48, stool_z_m, 0, {0.07, stool_height_m, 0.44}),
         piece(stool_x_m + 0.48, stool_z_m, 0, {0.07, stool_height_m, 0.44}),
         piece(stool_x_m, stool_z_m, 0.1, {0.9, 0.05, 0.08})});
    add(room, "albums", {piece(stool_x_m + 0.36, stool_z_m, stool_height_m + 0.06, {0.36, 0.07, 0.4})});
  }

  SceneContents room() const {
    SceneContents room;
    add_shell(room);
    add_furniture(room);
    room.camera = camera;
    room.sun = sun;
    return room;
  }
};

}  // namespace
}  // namespace bedroom_parts

SceneContents make_room(const RoomPlan& plan) {
  return bedroom_parts::RoomBuilder{plan}.room();
}

}  // namespace seamline::scenes
