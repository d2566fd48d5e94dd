// Every built-in object comes to rest on the floor of every built-in room that is a file by itself.
#include <gtest/gtest.h>

#include <limits>

#include "falling_bodies.h"
#include "raytracer/scene/resting_object.h"
#include "raytracer/scene/truth_scene.h"
#include "support/files/assets.h"

namespace seamline {
namespace {

using renderer::Ground;

/// The highest surface under a place.
double surface_below_m(const Ground& ground, const Eigen::Vector3d& place_m) {
  double highest_m = -std::numeric_limits<double>::infinity();
  for (const auto& corners : ground.triangles) {
    const Eigen::Vector3d& a = ground.vertices_m[corners[0]];
    const Eigen::Vector3d ab = ground.vertices_m[corners[1]] - a, ac = ground.vertices_m[corners[2]] - a,
                          ap = place_m - a;
    const double area = ab.x() * ac.z() - ab.z() * ac.x();
    if (area == 0) continue;
    const double u = (ap.x() * ac.z() - ap.z() * ac.x()) / area;
    const double v = (ab.x() * ap.z() - ab.z() * ap.x()) / area;
    const double y_m = a.y() + u * ab.y() + v * ac.y();
    if (u >= 0 && v >= 0 && u + v <= 1 && y_m < place_m.y()) highest_m = std::max(highest_m, y_m);
  }
  return highest_m;
}

TEST(RestingObject, BuiltInObjectsRestInBuiltInRooms) {
  SKIP_WITHOUT_BULLET();
  for (const std::string room : {"bedroom", "gazebo", "atrium", "furnished_room", "painted_room"}) {
    SceneDefinition definition;
    definition.path = resolve_named_file("builtin:" + room, "room");
    const renderer::TruthScene scene = renderer::load_truth_scene(definition, 32, 18);
    const Ground ground = renderer::ground_of(scene.background, scene.camera_position_m);
    Eigen::Vector3d ahead = -scene.camera.axes.col(2).cast<double>();
    ahead.y() = 0;
    const Eigen::Vector3d over_m = scene.camera_position_m + 2 * ahead.normalized();
    const double floor_m = surface_below_m(ground, over_m);
    for (const std::string name : {"statue", "teapot", "creature", "beast", "lion", "dragon"})
      for (const double lift_m : {0.01, 0.3}) {
        const renderer::SceneFile file =
            renderer::read_scene_file(resolve_named_file("builtin:" + name, "object"));
        const ObjectDefinition object{.name = name,
                                      .file = {},
                                      .path = {},
                                      .position_m = {over_m.x(), floor_m + lift_m, over_m.z()},
                                      .scale = 0.2};
        const renderer::RestingObject rests =
            renderer::rested(file, renderer::object_placement(object), ground, name);
        EXPECT_LE(rests.settled.seconds, 5) << name << " in " << room;
        EXPECT_NEAR(rests.placement.translation().y(), floor_m, 0.005) << name << " in " << room;
        EXPECT_LT(rests.settled.turned_deg, 5) << name << " in " << room;
        const std::string said = renderer::rest_sentence(name, rests);
        EXPECT_EQ(said.find("-0.00 "), std::string::npos) << said;
      }
  }
}

}  // namespace
}  // namespace seamline
