#include "raytracer/scene/figure_nodes.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <algorithm>

#include "raytracer/scene/gltf/gltf_pose.h"
#include "support/text/limits.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

constexpr double most_shear = 1e-4;

bool is_hidden_node(const tinygltf::Node& node) {
  const auto extension = node.extensions.find("KHR_node_visibility");
  return extension != node.extensions.end() && extension->second.Has("visible") &&
         extension->second.Get("visible").IsBool() && !extension->second.Get("visible").Get<bool>();
}

}  // namespace

JointPose joint_pose(const tinygltf::Node& node) {
  const Eigen::Affine3d local = GltfPose::local(node);
  JointPose place{.translation = local.translation()};
  if (node.matrix.size() != 16) {
    if (node.rotation.size() == 4 && Eigen::Vector4d(node.rotation.data()).norm() > 0)
      place.rotation =
          Eigen::Quaterniond(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2])
              .normalized();
    if (node.scale.size() == 3) place.scale = Eigen::Vector3d(node.scale.data());
    return place;
  }
  Eigen::Matrix3d axes = local.linear();
  place.scale = axes.colwise().norm();
  if (!(place.scale.minCoeff() > 0) || !(axes.determinant() > 0))
    throw NoFigure{fmt::format("its node \"{}\" is mirrored or flat", printable(node.name))};
  axes = axes * place.scale.cwiseInverse().asDiagonal();
  if ((axes.transpose() * axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > most_shear)
    throw NoFigure{fmt::format("its node \"{}\" is sheared", printable(node.name))};
  place.rotation = Eigen::Quaterniond(axes);
  return place;
}

FigureNodes::FigureNodes(const tinygltf::Model& model) : model_(model), parents_(model.nodes.size(), -1) {
  for (std::size_t node = 0; node < model.nodes.size(); ++node)
    for (const int child : model.nodes[node].children)
      if (exists(child)) parents_[static_cast<std::size_t>(child)] = static_cast<int>(node);
  visit_all([&](const MeshNode& visited) { reached_.push_back(visited.node); });
}

bool FigureNodes::exists(int node) const {
  return node >= 0 && static_cast<std::size_t>(node) < model_.nodes.size();
}

std::vector<int> FigureNodes::path_to(int node) const {
  std::vector<int> path;
  for (int depth = 0; node >= 0 && depth <= limits::deepest_node_tree; ++depth, node = parent_of(node))
    path.push_back(node);
  std::reverse(path.begin(), path.end());
  return path;
}

Eigen::Affine3d FigureNodes::world_of(int node) const {
  Eigen::Affine3d world = Eigen::Affine3d::Identity();
  for (const int one : path_to(node))
    world = world * GltfPose::local(model_.nodes[static_cast<std::size_t>(one)]);
  return world;
}

const tinygltf::Skin* FigureNodes::skin_of(int node) const {
  const int skin = model_.nodes[static_cast<std::size_t>(node)].skin;
  return skin >= 0 && static_cast<std::size_t>(skin) < model_.skins.size()
             ? &model_.skins[static_cast<std::size_t>(skin)]
             : nullptr;
}

std::vector<MeshNode> FigureNodes::meshes() const {
  std::vector<MeshNode> out;
  visit_all([&](const MeshNode& visited) {
    if (model_.nodes[static_cast<std::size_t>(visited.node)].mesh >= 0) out.push_back(visited);
  });
  return out;
}

void FigureNodes::visit_all(const std::function<void(const MeshNode&)>& take) const {
  std::vector<int> roots;
  if (model_.scenes.empty()) {
    for (std::size_t node = 0; node < model_.nodes.size(); ++node)
      if (parents_[node] < 0) roots.push_back(static_cast<int>(node));
  } else if (const auto scene = static_cast<std::size_t>(std::max(0, model_.defaultScene));
             scene < model_.scenes.size()) {
    roots = model_.scenes[scene].nodes;
  }
  std::vector<bool> visited(model_.nodes.size());
  for (const int root : roots) visit({root, Eigen::Affine3d::Identity()}, 0, visited, take);
}

void FigureNodes::visit(const MeshNode& below, int depth, std::vector<bool>& visited,
                        const std::function<void(const MeshNode&)>& take) const {
  if (!exists(below.node) || depth > limits::deepest_node_tree) return;
  const auto number = static_cast<std::size_t>(below.node);
  const tinygltf::Node& node = model_.nodes[number];
  if (visited[number] || is_hidden_node(node)) return;
  visited[number] = true;
  const Eigen::Affine3d world = below.world * GltfPose::local(node);
  take({below.node, world});
  for (const int child : node.children) visit({child, world}, depth + 1, visited, take);
}

}  // namespace seamline::renderer
