#include "raytracer/scene/gltf/gltf_mesh.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "raytracer/scene/gltf/tangents.h"
#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline::renderer {
namespace {

std::vector<Triangle> triangles_of(const std::vector<std::uint32_t>& corners, int mode) {
  std::vector<Triangle> triangles;
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return triangles;
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const bool strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP;
    const std::uint32_t first = strip ? corners[i - 2] : corners[0];
    const bool flipped = strip && i % 2 == 1;
    triangles.push_back(flipped ? Triangle{corners[i - 1], first, corners[i]}
                                : Triangle{first, corners[i - 1], corners[i]});
  }
  return triangles;
}

int mode_of(const tinygltf::Primitive& primitive) {
  return primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
}

}  // namespace

Eigen::Matrix3d normals_transform(const Eigen::Matrix3d& linear) {
  const Eigen::Matrix3d cofactor = (Eigen::Matrix3d() << linear.col(1).cross(linear.col(2)),
                                    linear.col(2).cross(linear.col(0)), linear.col(0).cross(linear.col(1)))
                                       .finished();
  return linear.determinant() < 0 ? Eigen::Matrix3d(-cofactor) : cofactor;
}

InputError GltfMeshes::bad(const std::string& field, const std::string& wanted,
                           const std::string& found) const {
  return input_error({.file = file_, .field = field, .wanted = wanted, .found = found});
}

/// Counts before the memory is taken: one mesh may be placed by many nodes.
void GltfMeshes::take(std::int64_t& total, std::int64_t more, std::int64_t most, const char* what,
                      const std::string& where) const {
  if (more <= most) total += more;
  if (more <= most && total <= most) return;
  throw bad(where, fmt::format("at most {} {} in a file", most, what), "more");
}

void GltfMeshes::add(const tinygltf::Node& node, const Eigen::Affine3d& world, const std::string& field,
                     std::vector<FileMesh>& out) {
  if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size())
    throw bad(field, "a mesh that exists", std::to_string(node.mesh));
  const tinygltf::Mesh& mesh = model_.meshes[node.mesh];
  for (const Eigen::Affine3d& instance : pose_.instances(node, field))
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const Placed placed{node, mesh, mesh.primitives[p], world * instance,
                          fmt::format("meshes[{}].primitives[{}]", node.mesh, p)};
      take(placed_meshes_, 1, limits::largest_scene_meshes, "placed meshes", placed.where);
      FileMesh piece = read(placed);
      piece.name = !node.name.empty() ? node.name : (!mesh.name.empty() ? mesh.name : placed.where);
      if (!piece.triangles.empty()) out.push_back(std::move(piece));
    }
}

bool GltfMeshes::has_surfaces(const tinygltf::Primitive& primitive) {
  const int mode = mode_of(primitive);
  if (mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
      mode == TINYGLTF_MODE_TRIANGLE_FAN)
    return true;
  left_out_.insert("points and lines");
  return false;
}

FileMesh GltfMeshes::read(const Placed& placed) {
  FileMesh piece;
  if (has_surfaces(placed.primitive)) read_shape(placed, piece);
  return piece;
}

void GltfMeshes::read_shape(const Placed& placed, FileMesh& piece) {
  const auto& attributes = placed.primitive.attributes;
  const std::string& where = placed.where;
  const auto position = attributes.find("POSITION");
  if (position == attributes.end()) throw bad(where, "an attribute POSITION", "none");
  take(placed_vertices_, reader_.count(position->second), limits::largest_scene_vertices, "placed vertices",
       where + ".POSITION");
  piece.positions_m = morphed(placed, "POSITION", reader_.vectors(position->second, where + ".POSITION"));
  std::vector<Eigen::Vector3d> normals;
  if (const auto normal = attributes.find("NORMAL"); normal != attributes.end()) {
    if (reader_.count(normal->second) != static_cast<std::int64_t>(piece.positions_m.size()))
      throw bad(where + ".NORMAL", "as many normals as positions",
                std::to_string(reader_.count(normal->second)));
    normals = morphed(placed, "NORMAL", reader_.vectors(normal->second, where + ".NORMAL"));
  }
  const VertexTransforms transforms = pose_.vertices(placed.node, placed.primitive, placed.world, where);
  const Eigen::Affine3d first = piece.positions_m.empty() ? placed.world : transforms.of(0);
  for (std::size_t i = 0; i < piece.positions_m.size(); ++i)
    piece.positions_m[i] = (transforms.is_rigid() ? first : transforms.of(i)) * piece.positions_m[i];
  const Eigen::Matrix3d first_of_normals = normals_transform(first.linear());
  piece.normals.reserve(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Eigen::Vector3d turned =
        transforms.is_rigid() ? Eigen::Vector3d(first_of_normals * normals[i])
                              : Eigen::Vector3d(normals_transform(transforms.of(i).linear()) * normals[i]);
    piece.normals.push_back(turned.normalized().cast<float>());
  }
  piece.triangles = triangles_of(corners(placed, piece.positions_m.size()), mode_of(placed.primitive));
  if (first.linear().determinant() < 0)
    for (Triangle& triangle : piece.triangles) std::swap(triangle[1], triangle[2]);
  read_colours(placed, piece);
  read_material(placed, transforms, piece);
}

std::vector<std::uint32_t> GltfMeshes::corners(const Placed& placed, std::size_t vertices) {
  const tinygltf::Primitive& primitive = placed.primitive;
  const std::int64_t count =
      primitive.indices >= 0 ? reader_.count(primitive.indices) : static_cast<std::int64_t>(vertices);
  take(placed_triangles_, mode_of(primitive) == TINYGLTF_MODE_TRIANGLES ? count / 3 : count,
       limits::largest_scene_triangles, "placed triangles", placed.where);
  std::vector<std::uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = reader_.indices(primitive.indices, placed.where + ".indices");
  } else {
    for (std::size_t i = 0; i < vertices; ++i) indices.push_back(static_cast<std::uint32_t>(i));
  }
  for (const std::uint32_t index : indices)
    if (index >= vertices)
      throw bad(placed.where + ".indices", fmt::format("indices under {}", vertices), std::to_string(index));
  return indices;
}

/// An attribute with its morph targets at the weights of the node, else of the mesh.
std::vector<Eigen::Vector3d> GltfMeshes::morphed(const Placed& placed, const char* attribute,
                                                 std::vector<Eigen::Vector3d> values) {
  const std::vector<double>& weights =
      placed.node.weights.empty() ? placed.mesh.weights : placed.node.weights;
  const auto& targets = placed.primitive.targets;
  for (std::size_t t = 0; t < std::min(weights.size(), targets.size()); ++t) {
    if (weights[t] == 0) continue;
    for (const auto& [name, accessor] : targets[t])
      if (name != "POSITION" && name != "NORMAL" && name != "TANGENT")
        left_out_.insert("morphed " +
                         std::string(name.starts_with("COLOR") ? "colours" : "texture coordinates"));
    const auto target = targets[t].find(attribute);
    if (target == targets[t].end()) continue;
    const std::string field = fmt::format("{}.targets[{}].{}", placed.where, t, attribute);
    take(placed_vertices_, reader_.count(target->second), limits::largest_scene_vertices, "placed vertices",
         field);
    const std::vector<Eigen::Vector3d> moved = reader_.vectors(target->second, field);
    if (moved.size() != values.size()) throw bad(field, "as many as positions", std::to_string(moved.size()));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += weights[t] * moved[i];
  }
  return values;
}

void GltfMeshes::read_colours(const Placed& placed, FileMesh& piece) {
  const auto& attributes = placed.primitive.attributes;
  if (attributes.contains("COLOR_1")) left_out_.insert("further sets of vertex colours");
  const auto found = attributes.find("COLOR_0");
  if (found == attributes.end()) return;
  const std::string field = placed.where + ".COLOR_0";
  check_count(found->second, field, piece);
  std::vector<Eigen::Array4f> colours = reader_.colours(found->second, field);
  const bool are_white = std::all_of(colours.begin(), colours.end(),
                                     [](const Eigen::Array4f& colour) { return (colour == 1.0F).all(); });
  if (!are_white) piece.colours = std::move(colours);
}

void GltfMeshes::read_material(const Placed& placed, const VertexTransforms& transforms, FileMesh& piece) {
  if (placed.primitive.material < 0) {
    if (piece.colours.empty()) return;
    Material coloured;
    coloured.name = "vertex colours";
    piece.material = std::make_shared<const Material>(std::move(coloured));
    piece.albedo = Rgb::Ones();
    return;
  }
  piece.material = materials_.read(placed.primitive.material, placed.where, alpha_kind(piece.colours));
  if (!piece.material) {
    piece.triangles.clear();
    return;
  }
  const Material& material = *piece.material;
  piece.albedo = material.base_colour;
  piece.emission = material.emission;
  for (const auto* texture : textures_of(material)) read_texture_coordinates(placed, texture->uv_set, piece);
  if (material.normal_texture) read_tangents(placed, transforms, piece);
}

void GltfMeshes::read_texture_coordinates(const Placed& placed, int set, FileMesh& piece) {
  const std::string name = fmt::format("TEXCOORD_{}", set);
  std::vector<Eigen::Vector2f>& uvs = piece.uvs[set];
  if (!uvs.empty()) return;
  const auto attribute = placed.primitive.attributes.find(name);
  if (attribute == placed.primitive.attributes.end()) {
    left_out_.insert(fmt::format("textures of meshes without {} (their first texel is everywhere)", name));
    uvs.assign(piece.positions_m.size(), Eigen::Vector2f::Zero());
    return;
  }
  check_count(attribute->second, placed.where + "." + name, piece);
  uvs = reader_.texture_coordinates(attribute->second, placed.where + "." + name);
}

void GltfMeshes::read_tangents(const Placed& placed, const VertexTransforms& transforms, FileMesh& piece) {
  const auto& attributes = placed.primitive.attributes;
  const Texture& texture = *piece.material->normal_texture;
  if (!attributes.contains(fmt::format("TEXCOORD_{}", texture.uv_set))) return;
  if (const auto tangent = attributes.find("TANGENT");
      tangent != attributes.end() && !piece.normals.empty()) {
    check_count(tangent->second, placed.where + ".TANGENT", piece);
    piece.tangents = reader_.tangents(tangent->second, placed.where + ".TANGENT");
    std::vector<Eigen::Vector3d> right;
    right.reserve(piece.tangents.size());
    for (const Eigen::Vector4f& one : piece.tangents) right.push_back(one.head<3>().cast<double>());
    right = morphed(placed, "TANGENT", std::move(right));
    for (std::size_t i = 0; i < piece.tangents.size(); ++i) {
      const Eigen::Matrix3d linear = transforms.of(i).linear();
      piece.tangents[i].head<3>() = (linear * right[i]).normalized().cast<float>();
      if (linear.determinant() < 0) piece.tangents[i][3] *= -1.0F;
    }
    return;
  }
  std::vector<Eigen::Vector2f> uvs;
  uvs.reserve(piece.positions_m.size());
  for (const Eigen::Vector2f& uv : piece.uvs[texture.uv_set])
    uvs.emplace_back(texture.transform * Eigen::Vector3f(uv.x(), uv.y(), 1.0F));
  piece.tangents = make_tangents(piece.positions_m, piece.normals, piece.triangles, uvs);
}

void GltfMeshes::check_count(int accessor, const std::string& field, const FileMesh& piece) const {
  if (reader_.count(accessor) != static_cast<std::int64_t>(piece.positions_m.size()))
    throw bad(field, "as many as positions", std::to_string(reader_.count(accessor)));
}

}  // namespace seamline::renderer
