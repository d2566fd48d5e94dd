#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/scene/gltf/file_mesh.h"
#include "raytracer/scene/gltf/transparency.h"
#include "stimuli/definition/surface/material_model.h"
#include "support/arithmetic/colour.h"

namespace seamline::renderer {

/// A perspective camera: axes are columns right, up, back in world space.
struct FileCamera {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  double vertical_fov_rad = 0.7;
};

/// A directional light of KHR_lights_punctual.
struct FileSun {
  Eigen::Vector3d to_sun = Eigen::Vector3d::UnitY();  ///< unit, towards the sun
  Rgb irradiance_w_m2 = Rgb::Zero();                  ///< lux / 683 times colour, on a plane facing the sun
};

/// A point or spot light of KHR_lights_punctual, in world space. Its range is not used: light falls off with
/// the square of distance.
struct FileLamp {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Rgb intensity_w_sr = Rgb::Zero();  ///< candela / 683 times colour
  bool is_spot = false;
  Eigen::Vector3d shines_along = -Eigen::Vector3d::UnitZ();  ///< unit
  double inner_rad = 0, outer_rad = 0.7853981633974483;
};

/// What a glTF 2.0 file holds, as far as a model of materials needs it.
struct SceneFile {
  std::vector<FileMesh> meshes;
  std::optional<FileCamera> camera;  ///< the first with a perspective, in node order
  std::vector<FileSun> suns;
  std::vector<FileLamp> lamps;
  std::string file = {};  ///< its path, for complaints
  /// What its materials have and the diffuse model leaves out: metals, gloss, normal maps.
  std::vector<std::string> left_out_of_diffuse = {};
  /// What no model shows, in plain words: animations, points and lines, clear coats and so on.
  std::vector<std::string> left_out = {};
};

/// Reads .gltf or .glb; nodes stand, skins and morph weights are as the file has them at rest. Throws
/// InputError naming the file and what in it is wrong: a truncated file, an accessor that points outside its
/// buffer, an index past the vertices, a required extension that is not known, a cycle of nodes, a material
/// that cannot be rendered (`GltfMaterials`).
[[nodiscard]] SceneFile read_scene_file(const std::filesystem::path& path,
                                        MaterialModel materials = MaterialModel::diffuse,
                                        Transparency transparency = Transparency::refused);

/// One line about what of the file no picture shows: "FILE: left out: ...". `also`: what of the file the
/// caller does not use. Empty: nothing is left out.
[[nodiscard]] std::string left_out_sentence(const SceneFile& file, const std::vector<std::string>& also = {});

/// The camera and lights of a file of which only the surfaces are used.
[[nodiscard]] std::vector<std::string> camera_and_lights(const SceneFile& file);

}  // namespace seamline::renderer
