#include "raytracer/scene/scene_file.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "raytracer/scene/gltf/gltf_load.h"
#include "raytracer/scene/gltf/gltf_mesh.h"
#include "raytracer/scene/scene_moment.h"
#include "support/arithmetic/units.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

constexpr int most_suns = 100;  ///< each is a ray a sample, and their light is added up
constexpr std::size_t most_lamps = 10'000;

/// Reads one file's nodes into a SceneFile, in node order.
class NodeWalker {
 public:
  NodeWalker(const tinygltf::Model& model, const std::string& file, MaterialModel materials,
             Transparency transparency, LeftOut& left_out)
      : model_(model),
        file_(file),
        left_out_(left_out),
        meshes_(model, file, materials, transparency, left_out) {}

  SceneFile walk() {
    if (model_.scenes.empty()) {
      const std::vector<bool> is_child = children();
      for (std::size_t node = 0; node < model_.nodes.size(); ++node)
        if (!is_child[node]) visit(static_cast<int>(node), Eigen::Affine3d::Identity(), 0);
    } else {
      const std::size_t scene = model_.defaultScene < 0 ? 0 : static_cast<std::size_t>(model_.defaultScene);
      if (scene >= model_.scenes.size()) throw bad("scene", "a scene that exists", std::to_string(scene));
      for (const int node : model_.scenes[scene].nodes) visit(node, Eigen::Affine3d::Identity(), 0);
    }
    out_.file = file_;
    if (further_cameras_ > 0) left_out_.insert(counted(further_cameras_, "further camera"));
    out_.left_out_of_diffuse.assign(meshes_.left_out_of_diffuse().begin(),
                                    meshes_.left_out_of_diffuse().end());
    out_.left_out.assign(left_out_.begin(), left_out_.end());
    return std::move(out_);
  }

 private:
  [[nodiscard]] InputError bad(const std::string& field, const std::string& wanted,
                               const std::string& found) const {
    return input_error({.file = file_, .field = field, .wanted = wanted, .found = found});
  }

  [[nodiscard]] std::vector<bool> children() const {
    std::vector<bool> is_child(model_.nodes.size());
    for (const tinygltf::Node& node : model_.nodes)
      for (const int child : node.children)
        if (child >= 0 && static_cast<std::size_t>(child) < is_child.size()) is_child[child] = true;
    return is_child;
  }

  /// KHR_node_visibility: such a node and all below it are not there.
  static bool is_hidden(const tinygltf::Node& node) {
    const auto extension = node.extensions.find("KHR_node_visibility");
    if (extension == node.extensions.end() || !extension->second.Has("visible")) return false;
    const tinygltf::Value& visible = extension->second.Get("visible");
    return visible.IsBool() && !visible.Get<bool>();
  }

  void visit(int index, const Eigen::Affine3d& parent, int depth) {
    const std::string field = fmt::format("nodes[{}]", index);
    if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size())
      throw bad(field, "a node that exists", "none");
    if (depth > limits::deepest_node_tree || !visited_.insert(index).second)
      throw bad(field, "a tree of nodes",
                depth > limits::deepest_node_tree ? "one too deep" : "a cycle, or a node with two parents");
    const tinygltf::Node& node = model_.nodes[index];
    if (is_hidden(node)) return;
    const Eigen::Affine3d world = parent * GltfPose::local(node);
    if (!world.matrix().allFinite()) throw bad(field, "a finite transform", "one that is not");
    if (node.mesh >= 0) meshes_.add(node, world, field, out_.meshes);
    if (node.camera >= 0) add_camera(node, world, field);
    add_light(node, world, field);
    for (const int child : node.children) visit(child, world, depth + 1);
  }

  /// Both are the file's, and so may be anything; so may their product.
  void check_light(const std::vector<double>& colour, double strength, const char* unit,
                   const std::string& field) const {
    for (const double channel : colour)
      if (!(channel >= 0 && channel <= limits::strongest_light && strength >= 0 &&
            strength <= limits::strongest_light && channel * strength <= limits::strongest_light))
        throw bad(field, fmt::format("light from 0 to {:g} {}", limits::strongest_light, unit),
                  fmt::format("{:g} times {:g}", channel, strength));
  }

  /// An axis of a node, which its transform may have made as short or long as no number can say.
  [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector3d& axis, const std::string& field) const {
    if (!std::isnormal(axis.squaredNorm()))
      throw bad(field, "a node whose axes have lengths", "one scaled to nothing or beyond numbers");
    return axis.normalized();
  }

  void add_camera(const tinygltf::Node& node, const Eigen::Affine3d& world, const std::string& field) {
    if (static_cast<std::size_t>(node.camera) >= model_.cameras.size())
      throw bad(field, "a camera that exists", std::to_string(node.camera));
    const tinygltf::Camera& camera = model_.cameras[node.camera];
    if (camera.type != "perspective") {
      left_out_.insert(fmt::format("a camera that is {}", printable(camera.type)));
      return;
    }
    if (!(camera.perspective.yfov > 0 && camera.perspective.yfov < 3.14)) {
      left_out_.insert("a camera without a yfov between 0 and pi");
      return;
    }
    if (out_.camera) {
      ++further_cameras_;
      return;
    }
    FileCamera view;
    view.position_m = world.translation();
    view.axes.col(2) = direction(world.linear().col(2), field);
    view.axes.col(0) = direction(world.linear().col(1).cross(view.axes.col(2)), field);
    view.axes.col(1) = view.axes.col(2).cross(view.axes.col(0));
    view.vertical_fov_rad = camera.perspective.yfov;
    out_.camera = view;
  }

  void add_light(const tinygltf::Node& node, const Eigen::Affine3d& world, const std::string& field) {
    const auto extension = node.extensions.find("KHR_lights_punctual");
    if (extension == node.extensions.end() || !extension->second.Has("light")) return;
    const int index = extension->second.Get("light").GetNumberAsInt();
    if (index < 0 || static_cast<std::size_t>(index) >= model_.lights.size())
      throw bad(field, "a light that exists", std::to_string(index));
    const tinygltf::Light& light = model_.lights[index];
    const std::vector<double> given = light.color.size() == 3 ? light.color : std::vector<double>{1, 1, 1};
    const std::string where = fmt::format("KHR_lights_punctual.lights[{}]", index);
    check_light(given, light.intensity / lux_per_w_m2, "W/m2 or W/sr (intensity / 683 times color)", where);
    const Rgb colour(given[0], given[1], given[2]);
    if (light.type != "directional") {
      add_lamp(light, colour, world, where, field);
      return;
    }
    out_.suns.push_back({direction(world.linear().col(2), field),
                         colour * static_cast<float>(light.intensity / lux_per_w_m2)});
    if (++suns_ > most_suns)
      throw bad(field, fmt::format("at most {} directional lights", most_suns), "more");
  }

  void add_lamp(const tinygltf::Light& light, const Rgb& colour, const Eigen::Affine3d& world,
                const std::string& where, const std::string& field) {
    if (light.range > 0) left_out_.insert("the range of lights (they fall off with the square of distance)");
    FileLamp lamp{.position_m = world.translation(),
                  .intensity_w_sr = colour * static_cast<float>(light.intensity / lux_per_w_m2)};
    if (light.type == "spot") {
      lamp.is_spot = true;
      lamp.shines_along = -direction(world.linear().col(2), field);
      lamp.inner_rad = light.spot.innerConeAngle;
      lamp.outer_rad = light.spot.outerConeAngle;
      if (!(lamp.inner_rad >= 0 && lamp.inner_rad <= lamp.outer_rad && lamp.outer_rad <= 1.5708))
        throw bad(where + ".spot", "cone angles with 0 <= inner <= outer <= pi / 2",
                  fmt::format("{:g} and {:g}", lamp.inner_rad, lamp.outer_rad));
    } else if (light.type != "point") {
      throw bad(where + ".type", "directional, point or spot", "\"" + light.type + "\"");
    }
    if (out_.lamps.size() == most_lamps)
      throw bad(field, fmt::format("at most {} point and spot lights", most_lamps), "more");
    out_.lamps.push_back(lamp);
  }

  const tinygltf::Model& model_;
  std::string file_;
  LeftOut& left_out_;
  GltfMeshes meshes_;
  SceneFile out_;
  std::set<int> visited_;
  int suns_ = 0, further_cameras_ = 0;
};

}  // namespace

SceneFile read_scene_file(const std::filesystem::path& path, MaterialModel materials,
                          Transparency transparency) {
  return read_scene_moment(path, materials, transparency, std::nullopt);
}

SceneFile read_scene_moment(const std::filesystem::path& path, MaterialModel materials,
                            Transparency transparency, const std::optional<FileMoment>& moment) {
  LeftOut left_out;
  GltfJson animations;
  const bool is_animated = moment && moment->is_animated;
  tinygltf::Model model = load_gltf(path, left_out, is_animated ? &animations : nullptr);
  if (is_animated) pose_at(*moment, animations, path.string(), model, left_out);
  if (moment) place_nodes(moment->nodes, path.string(), model);
  return NodeWalker(model, path.string(), materials, transparency, left_out).walk();
}

std::string left_out_sentence(const SceneFile& file, const std::vector<std::string>& also) {
  std::string names;
  for (const auto* list : {&file.left_out, &also})
    for (const std::string& one : *list) names += (names.empty() ? "" : "; ") + one;
  return names.empty() ? "" : fmt::format("{}: left out: {}", printable(file.file), names);
}

std::vector<std::string> camera_and_lights(const SceneFile& file) {
  std::vector<std::string> unused;
  if (file.camera) unused.emplace_back("its camera");
  if (const std::size_t lights = file.suns.size() + file.lamps.size(); lights > 0)
    unused.push_back(lights == 1 ? "its light" : fmt::format("its {} lights", lights));
  return unused;
}

}  // namespace seamline::renderer
