#include <Eigen/Geometry>
#include <cmath>

#include "scenes/families/family_parts.h"
#include "scenes/rooms/furniture.h"
#include "scenes/rooms/plans.h"

namespace seamline::scenes {
namespace {

/// Objects stand on a circle around the camera's foot.
constexpr double room_circle_m = 4.86, room_camera_z_m = 0.1;

RoomPlan random_room_plan(Random& random) {
  RoomPlan plan;
  plan.back_z_m = between(random, -6.5, -6.0);
  plan.right_x_m = between(random, 3.7, 4.3);
  plan.wall_height_m = between(random, 2.8, 3.5);
  plan.bed_x_m = between(random, -0.7, 0.3);
  plan.bed_height_m = between(random, 0.34, 0.5);
  plan.headboard_m = between(random, 0.7, 1.2);
  plan.wardrobe_x_m = between(random, -3.3, -2.9);
  plan.chest_x_m = between(random, 2.6, 3.0);
  plan.chest_width_m = between(random, 1.2, 1.8);
  plan.chest_height_m = between(random, 0.4, 0.8);
  plan.shelf_x_m = between(random, -0.4, 1.2);
  plan.shelf_height_m = between(random, 1.4, 1.75);
  plan.books = 5 + static_cast<int>(random.below(7));
  plan.stool_x_m = between(random, -0.15, 0.15);
  plan.stool_height_m = between(random, 0.2, 0.4);
  plan.stool_z_m = between(random, -4.95, -4.75);
  const double azimuth = between(random, 0.60, 0.85);  // from +Z to -X
  const double elevation = between(random, 0.27, 0.36);
  plan.sun.to_sun = Eigen::Vector3d(-std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                                    std::cos(azimuth) * std::cos(elevation));
  return plan;
}

void add_ornaments(SceneContents& room, const RoomPlan& plan, Random& random) {
  const auto put = [&](const std::string& name, const TriangleMesh& mesh, const Eigen::Vector3d& place_m) {
    room.parts.push_back({name, transformed(mesh, Eigen::Affine3d(Eigen::Translation3d(place_m)))});
  };
  if (random.uniform() < 0.7)
    put("picture", make_picture(between(random, 0.5, 1.0), between(random, 0.4, 0.7)),
        {between(random, 1.9, 3.0), between(random, 1.6, 2.2), plan.back_z_m + 0.02});
  if (random.uniform() < 0.6)
    put("vase", make_vase(between(random, 0.2, 0.35)),
        {plan.chest_x_m + between(random, -0.4, 0.4), plan.chest_height_m, plan.back_z_m + 0.3});
  if (random.uniform() < 0.5)
    put("plant", make_plant(between(random, 0.7, 1.1), random), {plan.right_x_m - 0.45, 0, -3.0});
  if (random.uniform() < 0.5)
    put("hanging_lamp", make_hanging_lamp(between(random, 0.5, 0.8)),
        {between(random, -1.0, 1.5), plan.wall_height_m, plan.back_z_m + 1.0});
}

}  // namespace

void place_in_room(GeneratedScene& scene, std::size_t object, Random& random) {
  PlacedObject& placed = scene.objects[object];
  constexpr std::array<double, 3> middle_x_m = {-1.65, -0.1, 1.5};
  const bool on_stool = object == 1;
  const double aside_m = on_stool ? between(random, -0.2, 0.1) : between(random, -0.35, 0.35);
  const double x = middle_x_m[object] + aside_m;
  placed.position_m.x() = x;
  placed.position_m.z() = on_stool ? scene.stool_z_m + between(random, -0.08, 0.14)
                                   : room_camera_z_m - std::sqrt(room_circle_m * room_circle_m - x * x) +
                                         between(random, -0.08, 0.08);
  placed.yaw_deg = (on_stool ? 20 : -9 * middle_x_m[object]) + between(random, -25, 25);
}

GeneratedScene generate_room(Random& random) {
  const RoomPlan plan = random_room_plan(random);
  GeneratedScene scene{
      .background = make_room(plan), .objects = {}, .settings = {}, .stool_z_m = plan.stool_z_m};
  add_ornaments(scene.background, plan, random);
  const bool statue_first = random.uniform() < 0.5;
  const PlacedObject statue{.name = "statue", .file = "builtin:statue", .scale = between(random, 0.82, 0.92)};
  const PlacedObject creature{
      .name = "creature", .file = "builtin:creature", .scale = between(random, 0.86, 0.96)};
  scene.objects = {statue_first ? statue : creature,
                   PlacedObject{.name = "teapot",
                                .file = "builtin:teapot",
                                .position_m = {0, plan.stool_height_m + 0.06, 0},
                                .scale = between(random, 0.7, 0.8),
                                .exempt_from_shape_rules = true},
                   statue_first ? creature : statue};
  for (std::size_t object = 0; object < 3; ++object) place_in_room(scene, object, random);
  scene.mirrored = random.uniform() < 0.5;
  scene.settings =
      "artifacts = [\"receiver\"]\nenvironment_radiance = [0.37, 0.395, 0.43]\nbounces = 4\nalbedo = 0.5\n"
      "exposure_ev = 0.3\n";
  return scene;
}

}  // namespace seamline::scenes
