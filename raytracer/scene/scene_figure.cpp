#include "raytracer/scene/scene_figure.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "raytracer/scene/animation_times.h"
#include "raytracer/scene/gltf/gltf_load.h"
#include "raytracer/scene/gltf/gltf_mesh.h"
#include "raytracer/scene/scene_moment.h"
#include "support/text/limits.h"

namespace seamline::renderer {
namespace {

constexpr double same_share = 1e-4;
constexpr std::size_t most_keys = 1'000'000;  ///< of all joints
constexpr std::size_t most_weight_sets = 8;

/// Why a file's figure cannot be said by joints that turn, move and grow.
struct NoFigure {
  std::string why;
};

bool are_alike(const Eigen::Affine3d& a, const Eigen::Affine3d& b) {
  const double size = std::max(1e-12, a.matrix().topRows<3>().cwiseAbs().maxCoeff());
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() <= same_share * size;
}

JointPlace place_of(const tinygltf::Node& node) {
  const Eigen::Affine3d local = GltfPose::local(node);
  JointPlace place{.translation = local.translation()};
  if (node.matrix.size() != 16) {
    if (node.rotation.size() == 4)
      place.rotation =
          Eigen::Quaterniond(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2])
              .normalized();
    if (node.scale.size() == 3) place.scale = Eigen::Vector3d(node.scale.data());
    return place;
  }
  Eigen::Matrix3d axes = local.linear();
  place.scale = axes.colwise().norm();
  if (!(place.scale.minCoeff() > 0) || !(axes.determinant() > 0))
    throw NoFigure{fmt::format("its node \"{}\" is mirrored or flat", node.name)};
  axes = axes * place.scale.cwiseInverse().asDiagonal();
  if ((axes.transpose() * axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > same_share)
    throw NoFigure{fmt::format("its node \"{}\" is sheared", node.name)};
  place.rotation = Eigen::Quaterniond(axes);
  return place;
}

class FigureReader {
 public:
  FigureReader(const FigureRequest& request, tinygltf::Model& model, const GltfJson& animations)
      : request_(request),
        model_(model),
        animations_(animations),
        file_(request.path.string()),
        reader_(model, file_),
        parents_(model.nodes.size(), -1) {
    for (std::size_t node = 0; node < model.nodes.size(); ++node)
      for (const int child : model.nodes[node].children)
        if (exists(child)) parents_[static_cast<std::size_t>(child)] = static_cast<int>(node);
  }

  /// Whether anything says that the file is a figure.
  [[nodiscard]] bool has_figure() const {
    for (const tinygltf::Node& node : model_.nodes)
      if (node.skin >= 0 && node.mesh >= 0) return true;
    std::set<std::string> names;
    for (const tinygltf::Node& node : model_.nodes)
      if (request_.is_joint && request_.is_joint(node.name)) names.insert(node.name);
    return names.size() >= request_.least_joints;
  }

  SceneFigure read() {
    choose_animation();
    if (request_.moment) pose(model_, request_.moment->time_s);
    find_meshes();
    find_joints();
    bind_joints();
    read_meshes();
    read_keys();
    return std::move(figure_);
  }

 private:
  struct MeshNode {
    int node = 0;
    Eigen::Affine3d world;
  };

  [[nodiscard]] bool exists(int node) const {
    return node >= 0 && static_cast<std::size_t>(node) < model_.nodes.size();
  }
  [[nodiscard]] const tinygltf::Node& at(int node) const {
    return model_.nodes.at(static_cast<std::size_t>(node));
  }
  [[nodiscard]] int parent_of(int node) const { return parents_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] std::vector<int> path_to(int node) const {
    std::vector<int> path;
    for (int depth = 0; node >= 0 && depth <= limits::deepest_node_tree; ++depth, node = parent_of(node))
      path.push_back(node);
    std::reverse(path.begin(), path.end());
    return path;
  }
  [[nodiscard]] Eigen::Affine3d world_of(int node) const {
    Eigen::Affine3d world = Eigen::Affine3d::Identity();
    for (const int one : path_to(node)) world = world * GltfPose::local(at(one));
    return world;
  }

  void choose_animation() {
    if (!animations_.is_array() || animations_.empty()) return;
    if (request_.moment)
      for (std::size_t i = 0; i < animations_.size(); ++i)
        if (text_of(animations_[i], "name") == request_.moment->animation ||
            std::to_string(i) == request_.moment->animation)
          animation_ = i;
    figure_.animation = text_of(animations_[animation_], "name");
    if (figure_.animation.empty()) figure_.animation = std::to_string(animation_);
    for (const std::int64_t node : animated_nodes(animations_[animation_]))
      if (std::in_range<int>(node) && exists(static_cast<int>(node))) moved_.insert(static_cast<int>(node));
  }

  void pose(tinygltf::Model& model, double time_s) const {
    LeftOut unused;
    pose_at({.animation = figure_.animation, .time_s = time_s}, animations_, file_, model, unused);
  }

  /// In the order of `read_scene_moment`.
  void find_meshes() {
    std::vector<int> roots;
    if (model_.scenes.empty()) {
      for (std::size_t node = 0; node < model_.nodes.size(); ++node)
        if (parents_[node] < 0) roots.push_back(static_cast<int>(node));
    } else {
      roots = model_.scenes.at(static_cast<std::size_t>(std::max(0, model_.defaultScene))).nodes;
    }
    for (const int root : roots) visit(root, Eigen::Affine3d::Identity(), 0);
  }

  void visit(int node, const Eigen::Affine3d& parent, int depth) {
    if (!exists(node) || depth > limits::deepest_node_tree) return;
    if (const auto extension = at(node).extensions.find("KHR_node_visibility");
        extension != at(node).extensions.end() && extension->second.Has("visible") &&
        extension->second.Get("visible").IsBool() && !extension->second.Get("visible").Get<bool>())
      return;
    const Eigen::Affine3d world = parent * GltfPose::local(at(node));
    if (at(node).mesh >= 0) mesh_nodes_.push_back({node, world});
    for (const int child : at(node).children) visit(child, world, depth + 1);
  }

  [[nodiscard]] const tinygltf::Skin* skin_of(const tinygltf::Node& node) const {
    return node.skin >= 0 && static_cast<std::size_t>(node.skin) < model_.skins.size()
               ? &model_.skins[static_cast<std::size_t>(node.skin)]
               : nullptr;
  }

  /// Joints of skins, nodes that the animation moves, nodes named as joints, and what lies above them.
  void find_joints() {
    std::set<int> own = moved_, all;
    for (const MeshNode& mesh : mesh_nodes_)
      if (const tinygltf::Skin* skin = skin_of(at(mesh.node))) {
        for (const int joint : skin->joints)
          if (exists(joint)) own.insert(joint);
      } else {
        all.insert(path_to(mesh.node).front());
      }
    for (std::size_t node = 0; node < model_.nodes.size(); ++node)
      if (request_.is_joint && request_.is_joint(model_.nodes[node].name)) own.insert(static_cast<int>(node));
    for (const int node : own)
      for (const int above : path_to(node)) all.insert(above);
    std::vector<int> tops;
    for (const int node : all)
      if (parent_of(node) < 0) tops.push_back(node);
    // What stands above the only joint is no joint.
    while (tops.size() == 1 && !own.contains(tops[0])) {
      const int top = tops[0];
      std::vector<int> below;
      for (const int child : at(top).children)
        if (all.contains(child)) below.push_back(child);
      const bool holds_mesh = std::any_of(mesh_nodes_.begin(), mesh_nodes_.end(), [&](const MeshNode& mesh) {
        if (skin_of(at(mesh.node)) != nullptr) return false;
        const std::vector<int> path = path_to(mesh.node);
        return below.size() != 1 || std::find(path.begin(), path.end(), below[0]) == path.end();
      });
      if (below.size() != 1 || holds_mesh) break;
      figure_.above_root = figure_.above_root * GltfPose::local(at(top));
      all.erase(top);
      tops = below;
    }
    if (tops.size() != 1) {
      figure_.joints.push_back({.name = {}, .parent = -1, .place = {}, .keys = {}});
      nodes_.push_back(-1);
    }
    const int root = tops.size() != 1 ? 0 : -1;
    for (const int top : tops) add_joint(top, root, all);
  }

  void add_joint(int node, int parent, const std::set<int>& all) {
    if (joint_of_.contains(node)) return;
    const int joint = static_cast<int>(figure_.joints.size());
    joint_of_[node] = joint;
    nodes_.push_back(node);
    figure_.joints.push_back(
        {.name = at(node).name, .parent = parent, .place = place_of(at(node)), .keys = {}});
    for (const int child : at(node).children)
      if (all.contains(child)) add_joint(child, joint, all);
  }

  [[nodiscard]] std::vector<Eigen::Affine3d> bound_by(const tinygltf::Skin& skin) const {
    std::vector<Eigen::Affine3d> bound(skin.joints.size(), Eigen::Affine3d::Identity());
    if (skin.inverseBindMatrices < 0) return bound;
    const auto inverse = reader_.transforms(skin.inverseBindMatrices, "inverseBindMatrices");
    for (std::size_t j = 0; j < bound.size(); ++j) {
      if (!(std::abs(inverse.at(j).linear().determinant()) > 0)) throw NoFigure{"its skin is bound flat"};
      bound[j] = inverse[j].inverse();
    }
    return bound;
  }

  void bind_joints() {
    std::set<int> bound;
    for (const MeshNode& mesh : mesh_nodes_) {
      const tinygltf::Skin* skin = skin_of(at(mesh.node));
      if (skin == nullptr) continue;
      const auto by_skin = bound_by(*skin);
      for (std::size_t j = 0; j < by_skin.size(); ++j) {
        const int joint = joint_of_.at(skin->joints[j]);
        if (!bound.insert(joint).second) continue;
        figure_.joints[static_cast<std::size_t>(joint)].bound = by_skin[j];
        if (bound.size() == 1) figure_.from_bound = world_of(skin->joints[j]) * by_skin[j].inverse();
      }
    }
    for (std::size_t j = 0; j < figure_.joints.size(); ++j) {
      if (bound.contains(static_cast<int>(j))) continue;
      FigureJoint& joint = figure_.joints[j];
      const Eigen::Affine3d above = joint.parent >= 0
                                        ? figure_.joints[static_cast<std::size_t>(joint.parent)].bound
                                        : figure_.from_bound.inverse() * figure_.above_root;
      joint.bound = nodes_[j] < 0 ? above : above * GltfPose::local(at(nodes_[j]));
    }
  }

  /// Each mesh as its file has it, without skin or node.
  void read_meshes() {
    tinygltf::Model plain = model_;
    for (tinygltf::Node& node : plain.nodes) node.skin = -1;
    LeftOut unused;
    GltfMeshes meshes(plain, file_, request_.materials, request_.transparency, unused);
    for (const MeshNode& mesh : mesh_nodes_) {
      const tinygltf::Node& node = at(mesh.node);
      if (node.extensions.contains("EXT_mesh_gpu_instancing"))
        throw NoFigure{"one of its meshes stands in several places"};
      const std::vector<tinygltf::Primitive> primitives =
          model_.meshes[static_cast<std::size_t>(node.mesh)].primitives;
      for (const tinygltf::Primitive& primitive : primitives) {
        plain.meshes[static_cast<std::size_t>(node.mesh)].primitives = {primitive};
        std::vector<FileMesh> pieces;
        meshes.add(plain.nodes[static_cast<std::size_t>(mesh.node)], Eigen::Affine3d::Identity(), "figure",
                   pieces);
        for (FileMesh& piece : pieces) figure_.meshes.push_back(hung(mesh, primitive, std::move(piece)));
      }
    }
  }

  [[nodiscard]] FigureSkin hung(const MeshNode& mesh, const tinygltf::Primitive& primitive,
                                FileMesh piece) const {
    FigureSkin out{.positions = std::move(piece.positions_m), .normals = std::move(piece.normals)};
    out.held_by.resize(out.positions.size());
    Eigen::Affine3d to_bound = Eigen::Affine3d::Identity();
    const tinygltf::Skin* skin = skin_of(at(mesh.node));
    if (skin == nullptr || !primitive.attributes.contains("JOINTS_0")) {
      if (skin != nullptr) throw NoFigure{"a mesh of its skin has no joints"};
      const std::vector<int> path = path_to(mesh.node);
      const auto holder =
          std::find_if(path.rbegin(), path.rend(), [&](int node) { return joint_of_.contains(node); });
      const int joint = holder == path.rend() ? 0 : joint_of_.at(*holder);
      const Eigen::Affine3d held = holder == path.rend() ? figure_.above_root : world_of(*holder);
      to_bound = figure_.joints[static_cast<std::size_t>(joint)].bound * held.inverse() * mesh.world;
      for (auto& one : out.held_by) one = {{joint, 1.0}};
    } else {
      to_bound = shared_bind(*skin);
      weigh(*skin, primitive, out);
    }
    const Eigen::Matrix3d turn = to_bound.linear().inverse().transpose();
    for (Eigen::Vector3d& position : out.positions) position = to_bound * position;
    for (Eigen::Vector3f& normal : out.normals)
      normal = (turn * normal.cast<double>()).normalized().cast<float>();
    return out;
  }

  /// From a skin's own bound pose to that of the skin that bound the joints first.
  [[nodiscard]] Eigen::Affine3d shared_bind(const tinygltf::Skin& skin) const {
    const auto by_skin = bound_by(skin);
    std::optional<Eigen::Affine3d> shared;
    for (std::size_t j = 0; j < by_skin.size(); ++j) {
      const FigureJoint& joint = figure_.joints[static_cast<std::size_t>(joint_of_.at(skin.joints[j]))];
      const Eigen::Affine3d one = joint.bound * by_skin[j].inverse();
      if (shared && !are_alike(*shared, one)) throw NoFigure{"its skins were bound in unlike poses"};
      if (!shared) shared = one;
    }
    return shared.value_or(Eigen::Affine3d::Identity());
  }

  void weigh(const tinygltf::Skin& skin, const tinygltf::Primitive& primitive, FigureSkin& out) const {
    for (std::size_t set = 0; set < most_weight_sets; ++set) {
      const auto held = primitive.attributes.find(fmt::format("JOINTS_{}", set));
      const auto weight = primitive.attributes.find(fmt::format("WEIGHTS_{}", set));
      if (held == primitive.attributes.end() || weight == primitive.attributes.end()) break;
      const auto joints = reader_.quadruples(held->second, held->first),
                 weights = reader_.quadruples(weight->second, weight->first);
      for (std::size_t i = 0; i < out.held_by.size(); ++i)
        for (int k = 0; k < 4; ++k)
          if (weights.at(i)[k] > 0)
            out.held_by[i].emplace_back(
                joint_of_.at(skin.joints.at(static_cast<std::size_t>(joints.at(i)[k]))), weights[i][k]);
    }
    for (auto& one : out.held_by) {
      double total = 0;
      for (const auto& held : one) total += held.second;
      for (auto& held : one) held.second /= total;
      if (one.empty()) one = {{joint_of_.at(skin.joints.at(0)), 1.0}};
    }
  }

  void read_keys() {
    if (!moved_.empty()) figure_.times_s = animation_times_s(animations_[animation_], reader_);
    if (figure_.times_s.size() < 2) {
      figure_.times_s.clear();
      figure_.animation.clear();
      return;
    }
    if (figure_.times_s.size() * figure_.joints.size() > most_keys)
      throw NoFigure{fmt::format("its animation has more than {} keys", most_keys)};
    tinygltf::Model moved = model_;
    for (const double time_s : figure_.times_s) {
      pose(moved, time_s);
      for (std::size_t j = 0; j < figure_.joints.size(); ++j)
        figure_.joints[j].keys.push_back(
            nodes_[j] < 0 ? JointPlace{} : place_of(moved.nodes[static_cast<std::size_t>(nodes_[j])]));
    }
  }

  const FigureRequest& request_;
  tinygltf::Model& model_;
  const GltfJson& animations_;
  std::string file_;
  GltfReader reader_;
  std::vector<int> parents_;  ///< of nodes; -1: a root
  std::size_t animation_ = 0;
  std::set<int> moved_;  ///< nodes that the animation moves
  std::vector<MeshNode> mesh_nodes_;
  std::map<int, int> joint_of_;  ///< by nodes
  std::vector<int> nodes_;       ///< of joints; -1: none
  SceneFigure figure_;
};

}  // namespace

FigureRead read_figure(const FigureRequest& request) {
  LeftOut unused;
  GltfJson animations;
  tinygltf::Model model = load_gltf(request.path, unused, &animations);
  FigureReader reader(request, model, animations);
  if (!reader.has_figure()) return {};
  try {
    return {.figure = reader.read(), .why_not = {}};
  } catch (const NoFigure& reason) {
    return {.figure = {}, .why_not = reason.why};
  }
}

}  // namespace seamline::renderer
