#include "raytracer/scene/gltf/gltf_pose.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <utility>

#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline::renderer {
namespace {

constexpr int most_joint_sets = 8;
constexpr const char* instancing = "EXT_mesh_gpu_instancing";

Eigen::Quaterniond rotation_of(const Eigen::Vector4d& xyzw) {
  if (!(xyzw.norm() > 0)) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(xyzw[3], xyzw[0], xyzw[1], xyzw[2]).normalized();
}

}  // namespace

Eigen::Affine3d VertexTransforms::of(std::size_t i) const {
  if (is_rigid()) return world_;
  Eigen::Affine3d sum;
  sum.matrix().setZero();
  double total = 0;
  for (std::size_t set = 0; set < weights_.size(); ++set)
    for (int k = 0; k < 4; ++k) {
      const double weight = std::max(0.0, weights_[set][i][k]);
      sum.matrix() += weight * joints_[static_cast<std::size_t>(held_by_[set][i][k])].matrix();
      total += weight;
    }
  if (!(total > 0)) return joints_[static_cast<std::size_t>(held_by_[0][i][0])];
  sum.matrix() /= total;
  return sum;
}

GltfPose::GltfPose(const tinygltf::Model& model, const GltfReader& reader, std::string file)
    : model_(model), reader_(reader), file_(std::move(file)), parents_(model.nodes.size(), -1) {
  for (std::size_t node = 0; node < model.nodes.size(); ++node)
    for (const int child : model.nodes[node].children)
      if (child >= 0 && static_cast<std::size_t>(child) < parents_.size())
        parents_[child] = static_cast<int>(node);
}

Eigen::Affine3d GltfPose::local(const tinygltf::Node& node) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (node.matrix.size() == 16) {
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
    return transform;
  }
  if (node.translation.size() == 3) transform.translate(Eigen::Vector3d(node.translation.data()));
  if (node.rotation.size() == 4)
    transform.rotate(
        Eigen::Quaterniond(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2])
            .normalized());
  if (node.scale.size() == 3) transform.scale(Eigen::Vector3d(node.scale.data()));
  return transform;
}

Eigen::Affine3d GltfPose::world(int node) const {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  for (int depth = 0; node >= 0 && depth <= limits::deepest_node_tree; ++depth) {
    transform = local(model_.nodes[node]) * transform;
    node = parents_[node];
  }
  return transform;
}

std::vector<Eigen::Affine3d> GltfPose::instances(const tinygltf::Node& node, const std::string& field) const {
  const auto extension = node.extensions.find(instancing);
  if (extension == node.extensions.end() || !extension->second.Has("attributes"))
    return {Eigen::Affine3d::Identity()};
  const tinygltf::Value& attributes = extension->second.Get("attributes");
  const std::string where = field + "." + instancing;
  const auto accessor = [&](const char* name) {
    return attributes.Has(name) && attributes.Get(name).IsInt() ? attributes.Get(name).Get<int>() : -1;
  };
  std::vector<Eigen::Affine3d> placed;
  const auto require_count = [&](std::size_t count) {
    if (placed.empty()) {
      if (std::cmp_greater(count, limits::largest_scene_meshes) || count == 0)
        throw input_error({.file = file_,
                           .field = where,
                           .wanted = fmt::format("1 to {} instances", limits::largest_scene_meshes),
                           .found = std::to_string(count)});
      placed.assign(count, Eigen::Affine3d::Identity());
    }
    if (placed.size() != count)
      throw input_error({.file = file_,
                         .field = where,
                         .wanted = "as many of every attribute",
                         .found = fmt::format("{} and {}", placed.size(), count)});
  };
  if (const int index = accessor("TRANSLATION"); index >= 0) {
    const auto values = reader_.vectors(index, where + ".TRANSLATION");
    require_count(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) placed[i].translate(values[i]);
  }
  if (const int index = accessor("ROTATION"); index >= 0) {
    const auto values = reader_.quadruples(index, where + ".ROTATION");
    require_count(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) placed[i].rotate(rotation_of(values[i]));
  }
  if (const int index = accessor("SCALE"); index >= 0) {
    const auto values = reader_.vectors(index, where + ".SCALE");
    require_count(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) placed[i].scale(values[i]);
  }
  if (placed.empty()) return {Eigen::Affine3d::Identity()};
  return placed;
}

std::vector<Eigen::Affine3d> GltfPose::joints_of(int skin, const std::string& where) const {
  const auto bad = [&](const std::string& wanted, const std::string& found) {
    return input_error({.file = file_, .field = where + ": skin", .wanted = wanted, .found = found});
  };
  if (static_cast<std::size_t>(skin) >= model_.skins.size())
    throw bad("a skin that exists", std::to_string(skin));
  const tinygltf::Skin& from = model_.skins[skin];
  std::vector<Eigen::Affine3d> from_mesh;
  if (from.inverseBindMatrices >= 0)
    from_mesh =
        reader_.transforms(from.inverseBindMatrices, fmt::format("skins[{}].inverseBindMatrices", skin));
  if (from.joints.empty() || (!from_mesh.empty() && from_mesh.size() < from.joints.size()))
    throw bad("joints, and an inverse bind matrix for each",
              fmt::format("{} and {}", from.joints.size(), from_mesh.size()));
  std::vector<Eigen::Affine3d> joints;
  for (std::size_t j = 0; j < from.joints.size(); ++j) {
    const int node = from.joints[j];
    if (node < 0 || static_cast<std::size_t>(node) >= model_.nodes.size())
      throw bad("joints that exist", std::to_string(node));
    joints.push_back(from_mesh.empty() ? world(node) : world(node) * from_mesh[j]);
    if (!joints.back().matrix().allFinite()) throw bad("finite transforms", "others");
  }
  return joints;
}

VertexTransforms GltfPose::vertices(const tinygltf::Node& node, const tinygltf::Primitive& primitive,
                                    const Eigen::Affine3d& world, const std::string& where) const {
  if (node.skin < 0) return VertexTransforms(world);
  const std::vector<Eigen::Affine3d> joints = joints_of(node.skin, where);
  std::vector<std::vector<Eigen::Vector4d>> held_by, weights;
  for (int set = 0; set < most_joint_sets; ++set) {
    const auto held = primitive.attributes.find(fmt::format("JOINTS_{}", set));
    const auto weight = primitive.attributes.find(fmt::format("WEIGHTS_{}", set));
    if (held == primitive.attributes.end() || weight == primitive.attributes.end()) break;
    held_by.push_back(reader_.quadruples(held->second, where + "." + held->first));
    weights.push_back(reader_.quadruples(weight->second, where + "." + weight->first));
    for (const Eigen::Vector4d& of_vertex : held_by.back())
      if (!(of_vertex.minCoeff() >= 0 && of_vertex.maxCoeff() < static_cast<double>(joints.size())))
        throw input_error({.file = file_,
                           .field = where + "." + held->first,
                           .wanted = fmt::format("joints under {}", joints.size()),
                           .found = fmt::format("{:g}", of_vertex.maxCoeff())});
  }
  const auto position = primitive.attributes.find("POSITION");
  const auto count =
      static_cast<std::size_t>(position == primitive.attributes.end() ? 0 : reader_.count(position->second));
  for (const auto* sets : {&held_by, &weights})
    for (const auto& of_vertices : *sets)
      if (of_vertices.size() != count)
        throw input_error({.file = file_,
                           .field = where,
                           .wanted = "as many joints and weights as positions",
                           .found = std::to_string(of_vertices.size())});
  if (held_by.empty()) return VertexTransforms(world);
  return {joints, std::move(held_by), std::move(weights)};
}

}  // namespace seamline::renderer
