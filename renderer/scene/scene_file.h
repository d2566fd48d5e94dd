#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/material/material.h"
#include "renderer/tracing/mesh.h"
#include "stimuli/definition/surface/material_model.h"
#include "support/arithmetic/colour.h"

namespace seamline::renderer {

/// One mesh primitive of a scene file in world space.
struct FileMesh {
  std::string name;  ///< of the node that places it
  std::vector<Eigen::Vector3d> positions_m;
  std::vector<Eigen::Vector3f> normals;  ///< unit shading normals, or empty
  std::vector<Triangle> triangles;
  std::optional<Rgb> albedo;                      ///< base colour factor; none when the mesh has no material
  Rgb emission = Rgb::Zero();                     ///< radiance
  std::shared_ptr<const Material> material = {};  ///< none when the mesh has none
  /// Of each vertex, TEXCOORD_0 and TEXCOORD_1; empty where no texture of the material asks for them.
  std::array<std::vector<Eigen::Vector2f>, 2> uvs = {};
  /// Of each vertex (`make_tangents`); empty without a normal texture.
  std::vector<Eigen::Vector4f> tangents = {};
};

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
  std::optional<FileCamera> camera;  ///< the first in node order
  std::vector<FileSun> suns;
  std::vector<FileLamp> lamps;
  std::string file = {};  ///< its path, for complaints
  /// What its materials have and the diffuse model leaves out: metals, gloss, normal maps, extensions.
  std::vector<std::string> left_out = {};
};

/// Reads .gltf or .glb. Throws InputError naming the file and what in it is wrong: a truncated file, an
/// accessor that points outside its buffer, an index past the vertices, a required extension that is not
/// known, a cycle of nodes, a material that cannot be rendered (`GltfMaterials`), a texture without
/// coordinates.
[[nodiscard]] SceneFile read_scene_file(const std::filesystem::path& path,
                                        MaterialModel materials = MaterialModel::diffuse);

}  // namespace seamline::renderer
