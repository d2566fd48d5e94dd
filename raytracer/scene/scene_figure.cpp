#include "raytracer/scene/scene_figure.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "raytracer/scene/animation_times.h"
#include "raytracer/scene/figure_nodes.h"
#include "raytracer/scene/gltf/gltf_load.h"
#include "raytracer/scene/gltf/gltf_mesh.h"
#include "raytracer/scene/scene_moment.h"
#include "support/text/limits.h"

namespace seamline::renderer {
namespace {

constexpr double same_share = 1e-4;
constexpr std::size_t most_keys = 1'000'000;  ///< of all joints
constexpr std::size_t most_joints = 10'000;
constexpr std::size_t most_weight_sets = 8;
constexpr double largest_number = 1e30;  ///< finite in single precision, and so are products

bool are_alike(const Eigen::Affine3d& a, const Eigen::Affine3d& b) {
  const double size = std::max(1e-12, a.matrix().topRows<3>().cwiseAbs().maxCoeff());
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() <= same_share * size;
}

bool is_whole(const Eigen::Affine3d& transform) {
  return transform.matrix().allFinite() && transform.inverse().matrix().allFinite();
}

template <class Numbers>
bool are_finite(const Numbers& numbers) {
  return numbers.allFinite() && static_cast<double>(numbers.cwiseAbs().maxCoeff()) < largest_number;
}

bool is_finite(const JointPose& place) {
  return are_finite(place.translation) && are_finite(place.rotation.coeffs()) && are_finite(place.scale);
}

bool is_finite(const SceneFigure& figure) {
  for (const FigureJoint& joint : figure.joints)
    if (!are_finite(joint.bound.matrix()) || !is_finite(joint.place) ||
        !std::all_of(joint.keys.begin(), joint.keys.end(),
                     [](const JointPose& key) { return is_finite(key); }))
      return false;
  for (const FigureSkin& mesh : figure.meshes)
    if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), are_finite<Eigen::Vector3d>) ||
        !std::all_of(mesh.normals.begin(), mesh.normals.end(), are_finite<Eigen::Vector3f>))
      return false;
  return are_finite(figure.above_root.matrix()) && are_finite(figure.from_bound.matrix());
}

class FigureReader {
 public:
  FigureReader(const FigureRequest& request, tinygltf::Model& model, const GltfJson& animations)
      : request_(request),
        model_(model),
        animations_(animations),
        file_(request.path.string()),
        reader_(model, file_),
        nodes_(model) {}

  /// Whether anything says that the file is a figure.
  [[nodiscard]] bool has_figure() const {
    std::set<std::string> names;
    for (const int node : nodes_.reached()) {
      if (at(node).skin >= 0 && at(node).mesh >= 0) return true;
      if (request_.is_joint && request_.is_joint(at(node).name)) names.insert(at(node).name);
    }
    return names.size() >= request_.least_joints;
  }

  SceneFigure read() {
    choose_animation();
    stand();
    mesh_nodes_ = nodes_.meshes();
    find_joints();
    bind_joints();
    read_meshes();
    read_keys();
    if (!is_finite(figure_)) throw NoFigure{"it has numbers that are not finite"};
    return std::move(figure_);
  }

 private:
  [[nodiscard]] const tinygltf::Node& at(int node) const {
    return model_.nodes.at(static_cast<std::size_t>(node));
  }

  [[nodiscard]] bool is_animated() const { return request_.moment && request_.moment->is_animated; }

  void choose_animation() {
    if (!animations_.is_array() || animations_.empty()) return;
    if (is_animated()) animation_ = animation_index(request_.moment->animation, animations_, file_);
    figure_.animation = text_of(animations_[animation_], "name");
    if (figure_.animation.empty()) figure_.animation = std::to_string(animation_);
    for (const std::int64_t node : animated_nodes(animations_[animation_]))
      if (std::in_range<int>(node) && nodes_.exists(static_cast<int>(node)))
        moved_.insert(static_cast<int>(node));
  }

  /// Nodes stand as `read_scene_moment` has them.
  void stand() {
    if (!request_.moment) return;
    LeftOut unused;
    if (is_animated()) pose_at(*request_.moment, animations_, file_, model_, unused);
    for (const PlacedNode& placed : request_.moment->nodes)
      for (std::size_t node = 0; node < model_.nodes.size(); ++node)
        if (model_.nodes[node].name == placed.name)
          unplaced_.emplace(static_cast<int>(node), model_.nodes[node]);
    place_nodes(request_.moment->nodes, file_, model_);
  }

  /// Joints of skins, nodes that the animation moves, nodes named as joints, and what lies above them.
  void find_joints() {
    std::set<int> own, all, known;  // known: what may be a joint
    known.insert(nodes_.reached().begin(), nodes_.reached().end());
    const auto take = [&](int node) {
      for (const int one : nodes_.path_to(node)) all.insert(one);
      if (all.size() > most_joints) throw NoFigure{fmt::format("it has more than {} joints", most_joints)};
    };
    for (const MeshNode& mesh : mesh_nodes_)
      if (const tinygltf::Skin* skin = nodes_.skin_of(mesh.node)) {
        for (const int joint : skin->joints)
          if (nodes_.exists(joint) && own.insert(joint).second) take(joint);
      } else {
        all.insert(nodes_.path_to(mesh.node).front());
      }
    known.insert(all.begin(), all.end());
    for (const int node : known)
      if (moved_.contains(node) || (request_.is_joint && request_.is_joint(at(node).name)))
        if (own.insert(node).second) take(node);
    std::erase_if(moved_, [&](int node) { return !known.contains(node); });
    std::vector<int> tops;
    for (const int node : all)
      if (nodes_.parent_of(node) < 0) tops.push_back(node);
    // What stands above the only joint is no joint.
    while (tops.size() == 1 && !own.contains(tops[0])) {
      const int top = tops[0];
      std::vector<int> below;
      for (const int child : at(top).children)
        if (all.contains(child)) below.push_back(child);
      const bool holds_mesh = std::any_of(mesh_nodes_.begin(), mesh_nodes_.end(), [&](const MeshNode& mesh) {
        if (nodes_.skin_of(mesh.node) != nullptr) return false;
        const std::vector<int> path = nodes_.path_to(mesh.node);
        return below.size() != 1 || std::find(path.begin(), path.end(), below[0]) == path.end();
      });
      if (below.size() != 1 || holds_mesh) break;
      figure_.above_root = figure_.above_root * GltfPose::local(at(top));
      all.erase(top);
      tops = below;
    }
    if (tops.size() != 1) {
      figure_.joints.push_back({.name = {}, .parent = -1, .place = {}, .keys = {}});
      node_of_.push_back(-1);
    }
    const int root = tops.size() != 1 ? 0 : -1;
    for (const int top : tops) add_joint(top, root, all, 0);
  }

  void add_joint(int node, int parent, const std::set<int>& all, int depth) {
    if (joint_of_.contains(node)) return;
    if (depth > limits::deepest_node_tree) throw NoFigure{"its joints are nested too deep"};
    const int joint = static_cast<int>(figure_.joints.size());
    joint_of_[node] = joint;
    node_of_.push_back(node);
    figure_.joints.push_back(
        {.name = at(node).name, .parent = parent, .place = joint_pose(at(node)), .keys = {}});
    for (const int child : at(node).children)
      if (all.contains(child)) add_joint(child, joint, all, depth + 1);
  }

  /// Throws NoFigure where a node is no joint, as in a cycle.
  [[nodiscard]] int joint_at(int node) const {
    const auto joint = joint_of_.find(node);
    if (joint == joint_of_.end()) throw NoFigure{"a joint of its skin stands in no tree of nodes"};
    return joint->second;
  }
  [[nodiscard]] int joint_at(const tinygltf::Skin& skin, double number) const {
    if (!(number >= 0 && number < static_cast<double>(skin.joints.size())))
      throw NoFigure{"its skin has not all the joints that hold it"};
    return joint_at(skin.joints[static_cast<std::size_t>(number)]);
  }

  [[nodiscard]] std::vector<Eigen::Affine3d> bound_by(const tinygltf::Skin& skin) const {
    std::vector<Eigen::Affine3d> bound(skin.joints.size(), Eigen::Affine3d::Identity());
    if (skin.inverseBindMatrices < 0) return bound;
    const auto inverse = reader_.transforms(skin.inverseBindMatrices, "inverseBindMatrices");
    for (std::size_t j = 0; j < bound.size(); ++j) {
      if (j >= inverse.size() || !(std::abs(inverse[j].linear().determinant()) > 0))
        throw NoFigure{"its skin is bound flat"};
      bound[j] = inverse[j].inverse();
    }
    return bound;
  }

  void bind_joints() {
    std::set<int> bound;
    for (const MeshNode& mesh : mesh_nodes_) {
      const tinygltf::Skin* skin = nodes_.skin_of(mesh.node);
      if (skin == nullptr) continue;
      const auto by_skin = bound_by(*skin);
      for (std::size_t j = 0; j < by_skin.size(); ++j) {
        const int joint = joint_at(skin->joints[j]);
        if (!bound.insert(joint).second) continue;
        figure_.joints[static_cast<std::size_t>(joint)].bound = by_skin[j];
        if (bound.size() == 1) figure_.from_bound = nodes_.world_of(skin->joints[j]) * by_skin[j].inverse();
      }
    }
    if (!is_whole(figure_.from_bound)) throw NoFigure{"a joint of its skin is flat"};
    for (std::size_t j = 0; j < figure_.joints.size(); ++j) {
      if (bound.contains(static_cast<int>(j))) continue;
      FigureJoint& joint = figure_.joints[j];
      const Eigen::Affine3d above = joint.parent >= 0
                                        ? figure_.joints[static_cast<std::size_t>(joint.parent)].bound
                                        : figure_.from_bound.inverse() * figure_.above_root;
      joint.bound = node_of_[j] < 0 ? above : above * GltfPose::local(at(node_of_[j]));
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
    const tinygltf::Skin* skin = nodes_.skin_of(mesh.node);
    if (skin == nullptr) {
      const std::vector<int> path = nodes_.path_to(mesh.node);
      const auto holder =
          std::find_if(path.rbegin(), path.rend(), [&](int node) { return joint_of_.contains(node); });
      if (holder == path.rend() || !are_alike(nodes_.world_of(mesh.node), mesh.world))
        throw NoFigure{"one of its meshes hangs on none of its joints"};
      const int joint = joint_at(*holder);
      to_bound = figure_.joints[static_cast<std::size_t>(joint)].bound;
      for (auto node = holder.base(); node != path.end(); ++node)
        to_bound = to_bound * GltfPose::local(at(*node));
      for (auto& one : out.held_by) one = {{joint, 1.0}};
    } else {
      to_bound = shared_bind(*skin);
      weigh(*skin, primitive, out);
    }
    const Eigen::Matrix3d turn = normals_transform(to_bound.linear());
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
      const FigureJoint& joint = figure_.joints[static_cast<std::size_t>(joint_at(skin.joints[j]))];
      const Eigen::Affine3d one = joint.bound * by_skin[j].inverse();
      if (shared && !are_alike(*shared, one)) throw NoFigure{"its skins were bound in unlike poses"};
      if (!shared) shared = one;
    }
    return shared.value_or(Eigen::Affine3d::Identity());
  }

  void weigh(const tinygltf::Skin& skin, const tinygltf::Primitive& primitive, FigureSkin& out) const {
    if (!primitive.attributes.contains("JOINTS_0") || !primitive.attributes.contains("WEIGHTS_0"))
      throw NoFigure{"a mesh of its skin has no joints or no weights"};
    std::vector<int> first(out.held_by.size());
    for (std::size_t set = 0; set < most_weight_sets; ++set) {
      const auto held = primitive.attributes.find(fmt::format("JOINTS_{}", set));
      const auto weight = primitive.attributes.find(fmt::format("WEIGHTS_{}", set));
      if (held == primitive.attributes.end() || weight == primitive.attributes.end()) break;
      const auto joints = reader_.quadruples(held->second, held->first),
                 weights = reader_.quadruples(weight->second, weight->first);
      if (joints.size() != out.held_by.size() || weights.size() != out.held_by.size())
        throw NoFigure{"its skin has not as many weights as vertices"};
      for (std::size_t i = 0; i < out.held_by.size(); ++i) {
        if (set == 0) first[i] = joint_at(skin, joints[i][0]);
        for (int k = 0; k < 4; ++k)
          if (weights[i][k] > 0) out.held_by[i].emplace_back(joint_at(skin, joints[i][k]), weights[i][k]);
      }
    }
    for (std::size_t i = 0; i < out.held_by.size(); ++i) {
      auto& one = out.held_by[i];
      double total = 0;
      for (const auto& held : one) total += held.second;
      for (auto& held : one) held.second /= total;
      if (one.empty()) one = {{first[i], 1.0}};  // as VertexTransforms::of
    }
  }

  void read_keys() {
    if (!moved_.empty()) figure_.times_s = animation_times_s(animations_[animation_], reader_);
    if (figure_.times_s.size() < 2) {
      figure_.times_s.clear();
      figure_.animation.clear();
      return;
    }
    const std::size_t times = figure_.times_s.size();
    if (times * figure_.joints.size() > most_keys ||
        times * count_of(animations_[animation_], "channels") > 4 * most_keys)
      throw NoFigure{fmt::format("its animation has more than {} keys", most_keys)};
    for (const auto& [number, node] : unplaced_) model_.nodes[static_cast<std::size_t>(number)] = node;
    const NodeMotion motion = node_motion(animation_, animations_, file_, model_);
    for (const double time_s : figure_.times_s) {
      motion(model_, time_s);
      tinygltf::Model placed;  // only what is placed, from where the animation has it
      for (const auto& [number, node] : unplaced_)
        placed.nodes.push_back(model_.nodes[static_cast<std::size_t>(number)]);
      if (!unplaced_.empty()) place_nodes(request_.moment->nodes, file_, placed);
      for (std::size_t j = 0; j < figure_.joints.size(); ++j) {
        const auto own = unplaced_.find(node_of_[j]);
        figure_.joints[j].keys.push_back(
            node_of_[j] < 0
                ? JointPose{}
                : joint_pose(
                      own == unplaced_.end()
                          ? at(node_of_[j])
                          : placed.nodes[static_cast<std::size_t>(std::distance(unplaced_.begin(), own))]));
      }
    }
  }

  const FigureRequest& request_;
  tinygltf::Model& model_;
  const GltfJson& animations_;
  std::string file_;
  GltfReader reader_;
  FigureNodes nodes_;
  std::size_t animation_ = 0;
  std::set<int> moved_;  ///< nodes that the animation moves
  std::vector<MeshNode> mesh_nodes_;
  std::map<int, int> joint_of_;             ///< by nodes
  std::vector<int> node_of_;                ///< of joints; -1: none
  std::map<int, tinygltf::Node> unplaced_;  ///< before the moment's nodes were placed
  SceneFigure figure_;
};

}  // namespace

FigureRead read_figure(const FigureRequest& request) {
  LeftOut unused;
  GltfJson animations;
  std::string why_not;
  tinygltf::Model model;
  try {
    model = load_gltf(request.path, unused, &animations);
  } catch (const InputError& error) {
    why_not = error.what();
    model = load_gltf(request.path, unused);
  }
  FigureReader reader(request, model, animations);
  if (!reader.has_figure()) return {};
  if (!why_not.empty()) return {.figure = {}, .why_not = why_not};
  try {
    return {.figure = reader.read(), .why_not = {}};
  } catch (const NoFigure& reason) {
    return {.figure = {}, .why_not = reason.why};
  } catch (const InputError& error) {  // of what stands in the file for its motion alone
    return {.figure = {}, .why_not = error.what()};
  }
}

}  // namespace seamline::renderer
