#pragma once
#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <vector>

#include "raytracer/scene/scene_figure.h"

namespace tinygltf {
class Model;
class Node;
struct Skin;
}  // namespace tinygltf

namespace seamline::renderer {

/// Why a file's figure cannot be said by joints that turn, move and grow.
struct NoFigure {
  std::string why;
};

/// Where a node stands in its parent. Throws NoFigure where it has a matrix that mirrors, flattens or shears.
[[nodiscard]] JointPose joint_pose(const tinygltf::Node& node);

/// A node that shows a mesh, and where.
struct MeshNode {
  int node = 0;
  Eigen::Affine3d world;
};

/// The tree of a file's nodes, as they stand when it is asked.
class FigureNodes {
 public:
  explicit FigureNodes(const tinygltf::Model& model);

  [[nodiscard]] bool exists(int node) const;
  [[nodiscard]] int parent_of(int node) const { return parents_[static_cast<std::size_t>(node)]; }
  /// From the root to a node; not all of it where it is longer than `limits::deepest_node_tree`.
  [[nodiscard]] std::vector<int> path_to(int node) const;
  [[nodiscard]] Eigen::Affine3d world_of(int node) const;
  /// Null without one.
  [[nodiscard]] const tinygltf::Skin* skin_of(int node) const;
  /// What the file's scene shows, in the order of `read_scene_moment`.
  [[nodiscard]] const std::vector<int>& reached() const { return reached_; }
  [[nodiscard]] std::vector<MeshNode> meshes() const;

 private:
  void visit_all(const std::function<void(const MeshNode&)>& take) const;
  void visit(const MeshNode& below, int depth, std::vector<bool>& visited,
             const std::function<void(const MeshNode&)>& take) const;

  const tinygltf::Model& model_;
  std::vector<int> parents_;  ///< -1: a root
  std::vector<int> reached_;
};

}  // namespace seamline::renderer
