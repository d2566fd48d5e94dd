#include "laboratory/settling/sensed_depth.h"

#include <memory>

#include "raytracer/common/parallel.h"
#include "raytracer/scene/scene_surfaces.h"
#include "renderer/depth/sensor/sensor_view.h"
#include "renderer/estimators/sensed_scene.h"
#include "sensors/noise/measurement.h"
#include "support/files/assets.h"
#include "support/text/request_name.h"

namespace seamline::renderer {

SensedDepth sense_depth(const DepthSubject& request) {
  const auto point_of = [](const std::array<double, 3>& v) { return Eigen::Vector3d(v[0], v[1], v[2]); };
  const sensors::Rig& rig = preset_rig(request.sensor, request_name("sensor"));
  const SceneFile file = read_scene_file(resolve_named_file(request.scene, "SCENE"));
  SceneDefinition definition;
  definition.path = request.scene;
  if (request.has_place)
    definition.camera = CameraDefinition{point_of(request.at_m), point_of(request.look_at_m)};
  const SensedScene scene = sensed_scene(file, definition, rig);
  const Eigen::Isometry3d seen_from = scene.world_from_colour * rig.colour_from_depth;
  const int threads = default_thread_count();
  const auto seen = std::make_shared<const sensors::SeenFrame>(
      see_truth(scene.truth, rig.depth, seen_from, sight_for(rig.noise, rig.projector_m), threads));
  SensedDepth depth;
  depth.may_be_z_up = may_be_z_up(file);
  depth.world_from_depth = Eigen::Translation3d(scene.centre_m) * seen_from;
  depth.measured = [=, noise = rig.noise, scale = request.noise_scale, seed = request.seed](int frame) {
    return sensors::measure(*seen, noise, {seed, static_cast<std::uint64_t>(frame)}, scale, threads).frame;
  };
  depth.exact = [exact = sensors::true_depth(*seen, sensors::convention_of(rig.noise))](int) {
    return exact;
  };
  return depth;
}

}  // namespace seamline::renderer
