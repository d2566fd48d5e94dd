#include <Eigen/Geometry>
#include <cmath>

#include "scenes/families/family_parts.h"
#include "scenes/rooms/plans.h"

namespace seamline::scenes {
namespace {

/// The bench in the aisle, on which the objects stand.
constexpr double bench_top_m = 0.72, behind_columns_m = 1.15;

ArcadePlan random_arcade_plan(Random& random) {
  ArcadePlan plan;
  plan.bay_m = between(random, 2.85, 3.2);
  plan.first_x_m = -4 * plan.bay_m;
  plan.spring_m = between(random, 2.6, 3.0);
  plan.storey_m = plan.spring_m + plan.bay_m / 2 + between(random, 0.15, 0.4);
  plan.shaft_m = between(random, 0.2, 0.3);
  plan.balusters = 5 + static_cast<int>(random.below(3));
  plan.beads = 1 + static_cast<int>(random.below(4));
  plan.rail_m = between(random, 1.9, 2.0);
  plan.camera.position_m = {between(random, 1.9, 2.6), between(random, 1.65, 1.85), 0.9};
  plan.camera.look_at_m.x() = between(random, 1.3, 1.7);
  return plan;
}

}  // namespace

void place_in_arcade(GeneratedScene& scene, std::size_t object, Random& random) {
  PlacedObject& placed = scene.objects[object];
  const double middle = (static_cast<double>(object) - 0.5) * scene.bay_m;
  placed.position_m = {middle + between(random, -0.3, 0.3), bench_top_m, -7.5 - behind_columns_m};
  placed.yaw_deg = between(random, -35, 35) + (random.uniform() < 0.3 ? 150 : 0);
}

GeneratedScene generate_arcade(Random& random) {
  const ArcadePlan plan = random_arcade_plan(random);
  GeneratedScene scene{.background = make_arcade(plan), .objects = {}, .settings = {}, .bay_m = plan.bay_m};
  for (std::size_t object = 0; object < 3; ++object) {
    scene.objects[object] = {.name = std::string("teapot_") + (object == 0   ? "left"
                                                               : object == 1 ? "middle"
                                                                             : "right"),
                             .file = "builtin:teapot",
                             .scale = 2.1 * between(random, 0.95, 1.05),
                             .exempt_from_shape_rules = true};
    place_in_arcade(scene, object, random);
  }
  scene.settings =
      "artifacts = [\"occlusion\"]\nenvironment_radiance = [1.0, 1.0, 1.0]\nambient_occlusion = true\n"
      "ao_distance_m = 2.0\nalbedo = 0.5\nexposure_ev = 0.32\n";
  return scene;
}

}  // namespace seamline::scenes
