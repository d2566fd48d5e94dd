#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "scenes/families/family_parts.h"
#include "scenes/rooms/furniture.h"
#include "scenes/rooms/plans.h"

namespace seamline::scenes {
namespace {

/// Where the crest's shadow falls on the lawn, and the circle around the camera's foot on which bodies lie.
constexpr double shadow_edge_z_m = -6.2, lawn_circle_m = 9.55, lawn_camera_z_m = 2.0;

PavilionPlan random_pavilion_plan(Random& random) {
  PavilionPlan plan;
  plan.eaves_m = between(random, 3.2, 3.7);
  plan.crest_m = between(random, 1.1, 1.6);
  plan.picket_m = between(random, 0.13, 0.21);
  plan.picket_pitch_m = plan.picket_m * between(random, 2.2, 2.7);
  plan.deck_height_m = 0.45;
  plan.half_width_m = between(random, 6.3, 7.2);
  plan.half_depth_m = between(random, 3.2, 3.8);
  plan.cut_m = between(random, 1.2, 2.0);
  plan.yaw_rad = between(random, -0.03, 0.09);
  const double aside = between(random, 0.30, 0.46), elevation = between(random, 0.46, 0.53);
  plan.sun.to_sun = Eigen::Vector3d(-std::sin(aside) * std::cos(elevation), std::sin(elevation),
                                    -std::cos(aside) * std::cos(elevation));
  // The shadow of the crest's middle lies at the wanted place.
  const double height = plan.eaves_m + 0.14 + plan.crest_m / 2;
  const double along_z = height * -plan.sun.to_sun.z() / plan.sun.to_sun.y();
  const double along_x = height * -plan.sun.to_sun.x() / plan.sun.to_sun.y();
  plan.centre_m = {-along_x + between(random, -0.6, 0.6), 0,
                   shadow_edge_z_m + between(random, -0.4, 0.2) - along_z - plan.half_depth_m};
  return plan;
}

void add_garden(SceneContents& garden, Random& random) {
  const int pots = static_cast<int>(random.below(4));
  for (int pot = 0; pot < pots; ++pot) {
    const double side = random.uniform() < 0.5 ? -1 : 1;
    const Eigen::Vector3d place_m(side * between(random, 7.5, 10), 0, between(random, -15, -12));
    garden.parts.push_back(
        {"plant_" + std::to_string(pot), transformed(make_plant(between(random, 1.2, 2.2), random),
                                                     Eigen::Affine3d(Eigen::Translation3d(place_m)))});
  }
}

}  // namespace

void place_by_pavilion(GeneratedScene& scene, std::size_t object, Random& random) {
  PlacedObject& placed = scene.objects[object];
  constexpr std::array<double, 3> middle_x_m = {-2.7, -0.15, 2.35};
  const double x = middle_x_m[object] + between(random, -0.25, 0.25);
  placed.position_m = {
      x, 0, lawn_camera_z_m - std::sqrt(lawn_circle_m * lawn_circle_m - x * x) + between(random, -0.2, 0.24)};
  placed.yaw_deg = 20 + between(random, -20, 20);
}

GeneratedScene generate_pavilion(Random& random) {
  const PavilionPlan plan = random_pavilion_plan(random);
  GeneratedScene scene{.background = make_pavilion(plan), .objects = {}, .settings = {}};
  add_garden(scene.background, random);
  std::array<PlacedObject, 3> bodies = {
      PlacedObject{.name = "beast", .file = "builtin:beast", .scale = 1.17},
      PlacedObject{.name = "lion", .file = "builtin:lion", .scale = 1.06},
      PlacedObject{.name = "dragon", .file = "builtin:dragon", .scale = 1.18}};
  shuffle(std::span<PlacedObject>(bodies), random);
  scene.objects = bodies;
  for (std::size_t object = 0; object < 3; ++object) {
    scene.objects[object].scale *= between(random, 0.95, 1.05);
    place_by_pavilion(scene, object, random);
  }
  scene.mirrored = random.uniform() < 0.5;
  scene.settings =
      "artifacts = [\"shadow\", \"overlap\"]\nenvironment_radiance = [0.74, 0.81, 0.92]\nbounces = 4\n"
      "albedo = 0.5\nexposure_ev = 0.15\n";
  return scene;
}

}  // namespace seamline::scenes
