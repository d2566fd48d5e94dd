#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/shapes/mesh.h"

namespace seamline::scenes {

/// One named piece of a scene. The name is what rules about surfaces count by ("floor", "bed", "wall_left").
struct ScenePart {
  std::string name;
  TriangleMesh mesh;
  std::array<double, 3> albedo = {0.5, 0.5, 0.5};  ///< linear RGB, diffuse
};

/// A perspective camera of aspect 16:9, level unless `look_at_m` says otherwise.
struct SceneCamera {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d look_at_m = -Eigen::Vector3d::UnitZ();
  double vertical_fov_rad = 0.6;
};

/// Sunlight: a direction and what a plane facing it receives.
struct SceneSun {
  Eigen::Vector3d to_sun = Eigen::Vector3d::UnitY();  ///< unit length, from the scene towards the sun
  double irradiance_w_m2 = 3.0;                       ///< the same in all three channels
};

/// What a built-in .glb holds. An object has parts only.
struct SceneContents {
  std::vector<ScenePart> parts;
  std::optional<SceneCamera> camera;
  std::optional<SceneSun> sun;
};

/// Lux of KHR_lights_punctual for 1 W/m2.
inline constexpr double lux_per_w_m2 = 683.0;

/// The aspect of every camera: stimuli are 960 x 540.
inline constexpr double camera_aspect = 960.0 / 540.0;

/// Writes glTF 2.0 binary: a node for each part, POSITION and NORMAL, 32-bit indices, a two-sided diffuse
/// material for each albedo (the first one 0.5, whether it is used or not); a camera node "camera"; a node
/// "sun" with a directional KHR_lights_punctual light, which shines along the node's -Z. Throws InputError
/// when the path cannot be written.
void write_glb(const std::filesystem::path& path, const SceneContents& contents);

/// Reads back what `write_glb` wrote: nodes with meshes by name, first camera, first sun. For tests.
[[nodiscard]] SceneContents read_glb(const std::filesystem::path& path);

}  // namespace seamline::scenes
