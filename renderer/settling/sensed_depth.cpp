#include "renderer/settling/sensed_depth.h"

#include <memory>

#include "renderer/common/parallel.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "renderer/depth/sensor/sensor_view.h"
#include "renderer/scene/truth_scene.h"
#include "sensors/noise/measurement.h"
#include "sensors/rig/presets.h"
#include "support/files/assets.h"
#include "support/text/error.h"

namespace seamline::renderer {

SensedDepth sense_depth(const SensedScene& request) {
  const auto point_of = [](const std::array<double, 3>& v) { return Eigen::Vector3d(v[0], v[1], v[2]); };
  const sensors::SensorPreset& preset = sensors::sensor_preset(request.sensor, "--sensor");
  const auto* rig = std::get_if<sensors::Rig>(&preset.sensor);
  if (rig == nullptr)
    throw input_error({.field = "--sensor",
                       .wanted = "a depth camera with a colour camera",
                       .found = request.sensor + ", a scanner"});
  const SceneFile file = read_scene_file(resolve_named_file(request.scene, "SCENE"));
  if (!request.has_place && !file.camera)
    throw input_error({.file = request.scene,
                       .wanted = "a camera in the scene, or --at X Y Z and --look-at X Y Z",
                       .found = "neither"});
  SceneDefinition scene;
  scene.path = request.scene;
  if (request.has_place) scene.camera = CameraDefinition{point_of(request.at_m), point_of(request.look_at_m)};
  Eigen::Vector3d centre_m;
  const Camera axes = scene_camera(scene, file, rig->colour.width_px, rig->colour.height_px, centre_m);
  const Geometry truth(place_meshes(file, Eigen::Affine3d::Identity(), centre_m, scene.albedo, 0));
  const Eigen::Isometry3d seen_from = world_from_photograph(axes) * rig->colour_from_depth;
  const int threads = default_thread_count();
  const auto seen = std::make_shared<const sensors::SeenFrame>(
      see_truth(truth, rig->depth, seen_from, sight_for(rig->noise, rig->projector_m), threads));
  SensedDepth depth;
  depth.world_from_depth = Eigen::Translation3d(centre_m) * seen_from;
  depth.measured = [=, noise = rig->noise, scale = request.noise_scale,
                    seed = static_cast<std::uint64_t>(request.seed)](int frame) {
    return sensors::measure(*seen, noise, {seed, static_cast<std::uint64_t>(frame)}, scale, threads).frame;
  };
  depth.exact = [exact = sensors::true_depth(*seen, sensors::convention_of(rig->noise))](int) {
    return exact;
  };
  return depth;
}

}  // namespace seamline::renderer
