#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/shapes/mesh.h"

namespace seamline::scenes {

/// What a surface is beside its colour. As it stands: diffuse, dark, of one colour.
struct SceneSurface {
  double roughness = 1, metallic = 0;
  std::array<double, 3> emission_w_m2_sr = {0, 0, 0};
  std::string pattern = {};  ///< of `make_pattern`, whose colours the albedo multiplies; empty: none
  std::vector<Eigen::Vector2d> pattern_m = {};  ///< one a vertex: where it lies in the pattern's plane
};

/// One named piece of a scene. The name is what rules about surfaces count by ("floor", "bed", "wall_left").
struct ScenePart {
  std::string name;
  TriangleMesh mesh;
  std::array<double, 3> albedo = {0.5, 0.5, 0.5};  ///< linear RGB
  SceneSurface surface = {};
};

/// The part with a pattern laid over it from the side to which each triangle turns most, in the axes of the
/// mesh: no two of its triangles share a vertex any more.
[[nodiscard]] ScenePart patterned(const ScenePart& part, const std::string& pattern);

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

/// A lamp without size.
struct SceneLamp {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double intensity_w_sr = 10;  ///< the same in all channels and directions
};

/// What a built-in .glb holds. An object has parts only.
struct SceneContents {
  std::vector<ScenePart> parts;
  std::optional<SceneCamera> camera;
  std::optional<SceneSun> sun;
  std::optional<SceneLamp> lamp = {};
};

/// The aspect of every camera: stimuli are 960 x 540.
inline constexpr double camera_aspect = 960.0 / 540.0;

/// Writes glTF 2.0 binary: a node for each part, POSITION and NORMAL, 32-bit indices, a two-sided
/// material for each albedo and surface (the first one diffuse and 0.5, whether it is used or not), patterns
/// as PNG pictures with TEXCOORD_0; a camera node "camera"; a node "sun" with a directional
/// KHR_lights_punctual light, which shines along the node's -Z; a node "lamp" with a point light. Throws
/// InputError when the path cannot be written.
void write_glb(const std::filesystem::path& path, const SceneContents& contents);

/// Reads back what `write_glb` wrote: nodes with meshes by name, first camera, first sun. For tests.
[[nodiscard]] SceneContents read_glb(const std::filesystem::path& path);

}  // namespace seamline::scenes
