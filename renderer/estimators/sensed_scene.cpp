#include "renderer/estimators/sensed_scene.h"

#include "raytracer/scene/truth_scene.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "renderer/depth/sensor/sensor_view.h"
#include "sensors/rig/presets.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::renderer {

SensedScene sensed_scene(const SceneFile& file, const SceneDefinition& definition, const sensors::Rig& rig) {
  if (!definition.camera && !file.camera)
    throw input_error({.file = file.file,
                       .wanted = "a camera in the scene, or " + request_name("at") + " X Y Z and " +
                                 request_name("look_at") + " X Y Z",
                       .found = "neither"});
  Eigen::Vector3d centre_m;
  const Camera axes = scene_camera(definition, file, rig.colour.width_px, rig.colour.height_px, centre_m);
  const auto meshes = place_meshes(file, Eigen::Affine3d::Identity(), centre_m, definition.albedo, 0);
  Light light = scene_light(definition, file, centre_m);
  add_emitters(meshes, light);
  return {.centre_m = centre_m,
          .world_from_colour = world_from_photograph(axes),
          .truth = Geometry(meshes),
          .light = std::move(light)};
}

SensedFrame sense_frame(const SensedScene& scene, const sensors::Rig& rig,
                        const Eigen::Isometry3d& world_from_colour, const SenseSettings& settings) {
  const int threads = settings.photograph.threads;
  SensedFrame frame;
  frame.seen = see_truth(scene.truth, rig.depth, world_from_colour * rig.colour_from_depth,
                         sight_for(rig.noise, rig.projector_m), threads);
  frame.measured = sensors::measure(frame.seen, rig.noise, settings.key, settings.noise_scale, threads);
  frame.colour =
      photograph_scene(scene.truth, scene.light, rig.colour, world_from_colour, settings.photograph);
  return frame;
}

const sensors::Rig& preset_rig(const std::string& key, const std::string& field) {
  const sensors::SensorPreset& preset = sensors::sensor_preset(key, field);
  if (const auto* rig = std::get_if<sensors::Rig>(&preset.sensor)) return *rig;
  throw input_error(
      {.field = field, .wanted = "a depth camera with a colour camera", .found = key + ", a scanner"});
}

}  // namespace seamline::renderer
