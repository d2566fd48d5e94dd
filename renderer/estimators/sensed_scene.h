#pragma once
#include <Eigen/Geometry>

#include "raytracer/scene/scene_file.h"
#include "renderer/estimators/rig_photograph.h"
#include "sensors/noise/measurement.h"
#include "sensors/rig/rig.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// A scene that a rig of cameras looks at. Its frame has the axes of the scene file's world and its origin
/// at `centre_m` there, the first place of the colour camera.
struct SensedScene {
  Eigen::Vector3d centre_m;
  Eigen::Isometry3d world_from_colour;  ///< the definition's camera, else the file's; at the origin
  Geometry truth;
  Light light;
};

/// What is taken of a scene at a moment.
struct SenseSettings {
  sensors::NoiseKey key = {};  ///< another one has other noise
  double noise_scale = 1;
  PhotographOptions photograph = {};  ///< its threads are everything's
};

/// What the rig's two cameras deliver.
struct SensedFrame {
  sensors::SeenFrame seen;
  sensors::Measurement measured;
  Image colour;  ///< linear
};

/// Places a scene for a rig. Throws InputError where neither the definition nor the file has a camera.
[[nodiscard]] SensedScene sensed_scene(const SceneFile& file, const SceneDefinition& definition,
                                       const sensors::Rig& rig);

/// Depth and colour of a scene from where the colour camera stands. The same bytes for any number of threads.
[[nodiscard]] SensedFrame sense_frame(const SensedScene& scene, const sensors::Rig& rig,
                                      const Eigen::Isometry3d& world_from_colour,
                                      const SenseSettings& settings);

/// The rig of a preset by its name. Throws InputError naming `field` where there is none, or where it has no
/// two cameras.
[[nodiscard]] const sensors::Rig& preset_rig(const std::string& key, const std::string& field);

}  // namespace seamline::renderer
