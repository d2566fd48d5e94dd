#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "raytracer/scene/gltf/file_mesh.h"
#include "raytracer/scene/gltf/gltf_accessor.h"
#include "raytracer/scene/gltf/gltf_material.h"
#include "raytracer/scene/gltf/gltf_pose.h"

namespace tinygltf {
class Model;
class Node;
struct Mesh;
struct Primitive;
}  // namespace tinygltf

namespace seamline::renderer {

/// What normals are multiplied with: of a transform that mirrors, its sign is that of the surface's own side.
[[nodiscard]] Eigen::Matrix3d normals_transform(const Eigen::Matrix3d& linear);

/// Reads the meshes that nodes place, into world space: with their skins and morph weights at rest, once for
/// each instance.
class GltfMeshes {
 public:
  GltfMeshes(const tinygltf::Model& model, const std::string& file, MaterialModel materials,
             Transparency transparency, LeftOut& left_out)
      : model_(model),
        file_(file),
        reader_(model, file),
        pose_(model, reader_, file),
        materials_(model, file, materials, transparency, left_out),
        left_out_(left_out) {}

  /// Adds what a node places. Throws InputError naming the part that is wrong, and where a file has more
  /// meshes, vertices or triangles than limits.h allows.
  void add(const tinygltf::Node& node, const Eigen::Affine3d& world, const std::string& field,
           std::vector<FileMesh>& out);

  /// What materials have and the diffuse model leaves out.
  [[nodiscard]] const std::set<std::string>& left_out_of_diffuse() const {
    return materials_.left_out_of_diffuse();
  }

 private:
  /// A primitive as one node places it.
  struct Placed {
    const tinygltf::Node& node;
    const tinygltf::Mesh& mesh;
    const tinygltf::Primitive& primitive;
    Eigen::Affine3d world;
    std::string where;
  };

  [[nodiscard]] InputError bad(const std::string& field, const std::string& wanted,
                               const std::string& found) const;
  void take(std::int64_t& total, std::int64_t more, std::int64_t most, const char* what,
            const std::string& where) const;
  [[nodiscard]] FileMesh read(const Placed& placed);
  [[nodiscard]] bool has_surfaces(const tinygltf::Primitive& primitive);
  [[nodiscard]] std::vector<std::uint32_t> corners(const Placed& placed, std::size_t vertices);
  void read_shape(const Placed& placed, FileMesh& piece);
  [[nodiscard]] std::vector<Eigen::Vector3d> morphed(const Placed& placed, const char* attribute,
                                                     std::vector<Eigen::Vector3d> values);
  void read_colours(const Placed& placed, FileMesh& piece);
  void read_material(const Placed& placed, const VertexTransforms& transforms, FileMesh& piece);
  void read_texture_coordinates(const Placed& placed, int set, FileMesh& piece);
  void read_tangents(const Placed& placed, const VertexTransforms& transforms, FileMesh& piece);
  void check_count(int accessor, const std::string& field, const FileMesh& piece) const;

  const tinygltf::Model& model_;
  std::string file_;
  GltfReader reader_;
  GltfPose pose_;
  GltfMaterials materials_;
  LeftOut& left_out_;
  std::int64_t placed_meshes_ = 0, placed_vertices_ = 0, placed_triangles_ = 0;
};

}  // namespace seamline::renderer
