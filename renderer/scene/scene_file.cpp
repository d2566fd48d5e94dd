#include "renderer/scene/scene_file.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "renderer/scene/gltf_accessor.h"
#include "renderer/scene/gltf_load.h"
#include "renderer/scene/gltf_material.h"
#include "renderer/scene/tangents.h"
#include "support/arithmetic/units.h"
#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline::renderer {
namespace {

constexpr int most_suns = 100;  ///< each is a ray a sample, and their light is added up
constexpr std::size_t most_lamps = 10'000;

/// Reads one file's nodes into a SceneFile, in node order.
class NodeWalker {
 public:
  NodeWalker(const tinygltf::Model& model, const std::string& file, MaterialModel materials)
      : model_(model), file_(file), reader_(model, file), materials_(model, file, materials) {}

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
    out_.left_out.assign(materials_.left_out().begin(), materials_.left_out().end());
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
        if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
          is_child[static_cast<std::size_t>(child)] = true;
    return is_child;
  }

  static Eigen::Affine3d local_transform(const tinygltf::Node& node) {
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

  void visit(int index, const Eigen::Affine3d& parent, int depth) {
    const std::string field = fmt::format("nodes[{}]", index);
    if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size())
      throw bad(field, "a node that exists", "none");
    if (depth > limits::deepest_node_tree || !visited_.insert(index).second)
      throw bad(field, "a tree of nodes",
                depth > limits::deepest_node_tree ? "one too deep" : "a cycle, or a node with two parents");
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
    const Eigen::Affine3d world = parent * local_transform(node);
    if (!world.matrix().allFinite()) throw bad(field, "a finite transform", "one that is not");
    if (node.mesh >= 0) add_mesh(node, world, field);
    if (node.camera >= 0) add_camera(node, world, field);
    add_light(node, world, field);
    for (const int child : node.children) visit(child, world, depth + 1);
  }

  void add_mesh(const tinygltf::Node& node, const Eigen::Affine3d& world, const std::string& field) {
    if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size())
      throw bad(field, "a mesh that exists", std::to_string(node.mesh));
    const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const std::string where = fmt::format("meshes[{}].primitives[{}]", node.mesh, p);
      take(placed_meshes_, 1, limits::largest_scene_meshes, "placed meshes", where);
      FileMesh piece = read_primitive(mesh.primitives[p], world, where);
      piece.name = !node.name.empty() ? node.name : (!mesh.name.empty() ? mesh.name : where);
      if (!piece.triangles.empty()) out_.meshes.push_back(std::move(piece));
    }
  }

  /// Counts before the memory is taken: one mesh may be placed by many nodes.
  void take(std::int64_t& total, std::int64_t more, std::int64_t most, const char* what,
            const std::string& where) const {
    if (more <= most && (total += more) <= most) return;
    throw bad(where, fmt::format("at most {} {} in a file", most, what), "more");
  }

  FileMesh read_primitive(const tinygltf::Primitive& primitive, const Eigen::Affine3d& world,
                          const std::string& where) {
    FileMesh piece;
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (mode != TINYGLTF_MODE_TRIANGLES && mode != TINYGLTF_MODE_TRIANGLE_STRIP &&
        mode != TINYGLTF_MODE_TRIANGLE_FAN)
      return piece;
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) throw bad(where, "an attribute POSITION", "none");
    take(placed_vertices_, reader_.count(position->second), limits::largest_scene_vertices, "placed vertices",
         where + ".POSITION");
    piece.positions_m = reader_.vectors(position->second, where + ".POSITION");
    for (Eigen::Vector3d& vertex : piece.positions_m) vertex = world * vertex;
    if (const auto normal = primitive.attributes.find("NORMAL"); normal != primitive.attributes.end())
      read_normals(normal->second, world, where, piece);
    std::vector<std::uint32_t> indices;
    const std::int64_t corners = primitive.indices >= 0 ? reader_.count(primitive.indices)
                                                        : static_cast<std::int64_t>(piece.positions_m.size());
    take(placed_triangles_, mode == TINYGLTF_MODE_TRIANGLES ? corners / 3 : corners,
         limits::largest_scene_triangles, "placed triangles", where);
    if (primitive.indices >= 0) {
      indices = reader_.indices(primitive.indices, where + ".indices");
    } else {
      for (std::size_t i = 0; i < piece.positions_m.size(); ++i)
        indices.push_back(static_cast<std::uint32_t>(i));
    }
    for (const std::uint32_t index : indices)
      if (index >= piece.positions_m.size())
        throw bad(where + ".indices", fmt::format("indices under {}", piece.positions_m.size()),
                  std::to_string(index));
    piece.triangles = triangles_of(indices, mode);
    if (primitive.material >= 0) read_material(primitive, world, where, piece);
    return piece;
  }

  void read_normals(int accessor, const Eigen::Affine3d& world, const std::string& where, FileMesh& piece) {
    if (reader_.count(accessor) != static_cast<std::int64_t>(piece.positions_m.size()))
      throw bad(where + ".NORMAL", "as many normals as positions", std::to_string(reader_.count(accessor)));
    const std::vector<Eigen::Vector3d> normals = reader_.vectors(accessor, where + ".NORMAL");
    const Eigen::Matrix3d linear = world.linear();
    const Eigen::Matrix3d cofactor = (Eigen::Matrix3d() << linear.col(1).cross(linear.col(2)),
                                      linear.col(2).cross(linear.col(0)), linear.col(0).cross(linear.col(1)))
                                         .finished();
    piece.normals.reserve(normals.size());
    for (const Eigen::Vector3d& normal : normals)
      piece.normals.push_back((cofactor * normal).normalized().cast<float>());
  }

  static std::vector<Triangle> triangles_of(const std::vector<std::uint32_t>& indices, int mode) {
    std::vector<Triangle> triangles;
    if (mode == TINYGLTF_MODE_TRIANGLES) {
      for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
      return triangles;
    }
    for (std::size_t i = 2; i < indices.size(); ++i) {
      const bool strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP;
      const std::uint32_t first = strip ? indices[i - 2] : indices[0];
      const bool flipped = strip && i % 2 == 1;
      triangles.push_back(flipped ? Triangle{indices[i - 1], first, indices[i]}
                                  : Triangle{first, indices[i - 1], indices[i]});
    }
    return triangles;
  }

  void read_material(const tinygltf::Primitive& primitive, const Eigen::Affine3d& world,
                     const std::string& where, FileMesh& piece) {
    piece.material = materials_.read(primitive.material, where);
    const Material& material = *piece.material;
    piece.albedo = material.base_colour;
    piece.emission = material.emission;
    for (const auto* texture : {&material.base_colour_texture, &material.emission_texture,
                                &material.metallic_roughness_texture, &material.normal_texture})
      if (*texture) read_texture_coordinates(primitive, (*texture)->uv_set, where, piece);
    if (material.normal_texture) read_tangents(primitive, world, where, piece);
  }

  void read_texture_coordinates(const tinygltf::Primitive& primitive, int set, const std::string& where,
                                FileMesh& piece) const {
    const std::string name = fmt::format("TEXCOORD_{}", set);
    const auto attribute = primitive.attributes.find(name);
    if (attribute == primitive.attributes.end())
      throw bad(where, fmt::format("{} for the textures of its material", name), "none");
    std::vector<Eigen::Vector2f>& uvs = piece.uvs[static_cast<std::size_t>(set)];
    if (!uvs.empty()) return;
    check_count(attribute->second, where + "." + name, piece);
    uvs = reader_.texture_coordinates(attribute->second, where + "." + name);
  }

  void read_tangents(const tinygltf::Primitive& primitive, const Eigen::Affine3d& world,
                     const std::string& where, FileMesh& piece) const {
    if (const auto tangent = primitive.attributes.find("TANGENT"); tangent != primitive.attributes.end()) {
      check_count(tangent->second, where + ".TANGENT", piece);
      piece.tangents = reader_.tangents(tangent->second, where + ".TANGENT");
      for (Eigen::Vector4f& one : piece.tangents)
        one.head<3>() = (world.linear() * one.head<3>().cast<double>()).normalized().cast<float>();
      return;
    }
    const Texture& texture = *piece.material->normal_texture;
    std::vector<Eigen::Vector2f> uvs;
    uvs.reserve(piece.positions_m.size());
    for (const Eigen::Vector2f& uv : piece.uvs[static_cast<std::size_t>(texture.uv_set)])
      uvs.emplace_back(texture.transform * Eigen::Vector3f(uv.x(), uv.y(), 1.0F));
    piece.tangents = make_tangents(piece.positions_m, piece.normals, piece.triangles, uvs);
  }

  void check_count(int accessor, const std::string& field, const FileMesh& piece) const {
    if (reader_.count(accessor) != static_cast<std::int64_t>(piece.positions_m.size()))
      throw bad(field, "as many as positions", std::to_string(reader_.count(accessor)));
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
    if (out_.camera) return;
    if (static_cast<std::size_t>(node.camera) >= model_.cameras.size())
      throw bad(field, "a camera that exists", std::to_string(node.camera));
    const tinygltf::Camera& camera = model_.cameras[static_cast<std::size_t>(node.camera)];
    if (camera.type != "perspective" || !(camera.perspective.yfov > 0 && camera.perspective.yfov < 3.14))
      throw bad(field + ".camera", "a perspective camera with yfov between 0 and pi", camera.type);
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
    const tinygltf::Light& light = model_.lights[static_cast<std::size_t>(index)];
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
  GltfReader reader_;
  GltfMaterials materials_;
  SceneFile out_;
  std::set<int> visited_;
  int suns_ = 0;
  std::int64_t placed_meshes_ = 0, placed_vertices_ = 0, placed_triangles_ = 0;
};

}  // namespace

SceneFile read_scene_file(const std::filesystem::path& path, MaterialModel materials) {
  const tinygltf::Model model = load_gltf(path);
  return NodeWalker(model, path.string(), materials).walk();
}

}  // namespace seamline::renderer
