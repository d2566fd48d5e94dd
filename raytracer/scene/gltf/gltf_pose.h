#pragma once
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "raytracer/scene/gltf/gltf_accessor.h"

namespace tinygltf {
class Model;
class Node;
struct Primitive;
}  // namespace tinygltf

namespace seamline::renderer {

/// Where the vertices of a placed primitive come to lie: by their node's transform, or each by the joints
/// that its skin weighs, as the file's nodes stand (glTF 2.0, 3.7.3.3).
class VertexTransforms {
 public:
  explicit VertexTransforms(const Eigen::Affine3d& world) : world_(world) {}
  /// A skin: its joints' transforms from the mesh to the world, and of each vertex which joints hold it and
  /// how much, four a set.
  VertexTransforms(std::vector<Eigen::Affine3d> joints, std::vector<std::vector<Eigen::Vector4d>> held_by,
                   std::vector<std::vector<Eigen::Vector4d>> weights)
      : joints_(std::move(joints)), held_by_(std::move(held_by)), weights_(std::move(weights)) {}

  [[nodiscard]] bool is_rigid() const { return joints_.empty(); }
  /// Of vertex i; of a rigid one, the same for all.
  [[nodiscard]] Eigen::Affine3d of(std::size_t i) const;

 private:
  Eigen::Affine3d world_ = Eigen::Affine3d::Identity();
  std::vector<Eigen::Affine3d> joints_;
  std::vector<std::vector<Eigen::Vector4d>> held_by_, weights_;
};

/// The transforms of a file's nodes at rest, and what hangs on them.
class GltfPose {
 public:
  GltfPose(const tinygltf::Model& model, const GltfReader& reader, std::string file);

  /// A node's own transform. Throws InputError where it is not finite.
  [[nodiscard]] static Eigen::Affine3d local(const tinygltf::Node& node);
  /// Where EXT_mesh_gpu_instancing places a node's mesh, within the node; one identity without it. Throws
  /// InputError naming the node.
  [[nodiscard]] std::vector<Eigen::Affine3d> instances(const tinygltf::Node& node,
                                                       const std::string& field) const;
  /// Of a primitive that a node places with this transform. Throws InputError naming the primitive: a skin or
  /// joint that does not exist.
  [[nodiscard]] VertexTransforms vertices(const tinygltf::Node& node, const tinygltf::Primitive& primitive,
                                          const Eigen::Affine3d& world, const std::string& where) const;

 private:
  [[nodiscard]] Eigen::Affine3d world(int node) const;
  [[nodiscard]] std::vector<Eigen::Affine3d> joints_of(int skin, const std::string& where) const;

  const tinygltf::Model& model_;
  const GltfReader& reader_;
  std::string file_;
  std::vector<int> parents_;  ///< -1: a root
};

}  // namespace seamline::renderer
