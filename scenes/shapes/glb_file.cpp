// The only file of this folder that includes tinygltf.
#include "scenes/shapes/glb_file.h"

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <cstring>
#include <span>

#include "support/files/gltf_writing.h"
#include "support/text/error.h"

namespace seamline::scenes {
namespace fs = std::filesystem;
namespace {

using Vector3d = Eigen::Vector3d;
constexpr const char* light_extension = "KHR_lights_punctual";

/// The rotation that takes -Z, where glTF's cameras look and lights shine, to `direction`, and keeps +Y up.
Eigen::Quaterniond looking_along(const Vector3d& direction) {
  const Vector3d back = -direction.normalized();
  const Vector3d up = std::abs(back.y()) < 0.999 ? Vector3d::UnitY() : Vector3d::UnitZ();
  const Vector3d right = up.cross(back).normalized();
  Eigen::Matrix3d axes;
  axes << right, back.cross(right), back;
  return Eigen::Quaterniond(axes);
}

std::vector<double> xyzw(const Eigen::Quaterniond& q) {
  return {q.x(), q.y(), q.z(), q.w()};
}

int add_vectors(tinygltf::Model& model, const std::vector<Vector3d>& vectors, bool with_range) {
  std::vector<float> values;
  std::vector<double> low(3, 1e300);
  std::vector<double> high(3, -1e300);
  for (const Vector3d& vector : vectors)
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      values.push_back(static_cast<float>(vector[axis]));
      low[at] = std::min(low[at], static_cast<double>(values.back()));
      high[at] = std::max(high[at], static_cast<double>(values.back()));
    }
  const int number =
      add_accessor(model, std::as_bytes(std::span(values)),
                   {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER});
  if (with_range) {
    model.accessors.back().minValues = low;
    model.accessors.back().maxValues = high;
  }
  return number;
}

void add_node(tinygltf::Model& model, const tinygltf::Node& node) {
  model.nodes.push_back(node);
  model.scenes[0].nodes.push_back(static_cast<int>(model.nodes.size()) - 1);
}

tinygltf::Material diffuse(const std::array<double, 3>& albedo, const std::string& name) {
  tinygltf::Material material;
  material.name = name;
  material.doubleSided = true;
  material.pbrMetallicRoughness.baseColorFactor = {albedo[0], albedo[1], albedo[2], 1.0};
  material.pbrMetallicRoughness.metallicFactor = 0.0;
  material.pbrMetallicRoughness.roughnessFactor = 1.0;
  return material;
}

/// The material of an albedo, which is added where there is none.
int material_of(tinygltf::Model& model, const ScenePart& part) {
  const std::vector<double> colour = {part.albedo[0], part.albedo[1], part.albedo[2], 1.0};
  for (std::size_t i = 0; i < model.materials.size(); ++i)
    if (model.materials[i].pbrMetallicRoughness.baseColorFactor == colour) return static_cast<int>(i);
  model.materials.push_back(diffuse(part.albedo, part.name));
  return static_cast<int>(model.materials.size()) - 1;
}

void add_part(tinygltf::Model& model, const ScenePart& part) {
  std::vector<std::uint32_t> indices;
  for (const auto& triangle : part.mesh.triangles)
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = material_of(model, part);
  primitive.attributes["POSITION"] = add_vectors(model, part.mesh.positions_m, true);
  primitive.attributes["NORMAL"] = add_vectors(model, part.mesh.normals, false);
  primitive.indices = add_accessor(
      model, std::as_bytes(std::span(indices)),
      {TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER});
  tinygltf::Mesh mesh;
  mesh.name = part.name;
  mesh.primitives.push_back(primitive);
  model.meshes.push_back(mesh);
  tinygltf::Node node;
  node.name = part.name;
  node.mesh = static_cast<int>(model.meshes.size()) - 1;
  add_node(model, node);
}

void add_camera(tinygltf::Model& model, const SceneCamera& scene_camera) {
  tinygltf::Camera camera;
  camera.name = "camera";
  camera.type = "perspective";
  camera.perspective.yfov = scene_camera.vertical_fov_rad;
  camera.perspective.aspectRatio = camera_aspect;
  camera.perspective.znear = 0.01;
  camera.perspective.zfar = 1000;
  model.cameras.push_back(camera);
  tinygltf::Node node;
  node.name = "camera";
  node.camera = 0;
  const Vector3d& p = scene_camera.position_m;
  node.translation = {p.x(), p.y(), p.z()};
  node.rotation = xyzw(looking_along(scene_camera.look_at_m - p));
  add_node(model, node);
}

void add_sun(tinygltf::Model& model, const SceneSun& sun) {
  tinygltf::Light light;
  light.name = "sun";
  light.type = "directional";
  light.color = {1, 1, 1};
  light.intensity = lux_per_w_m2 * sun.irradiance_w_m2;
  model.lights.push_back(light);
  tinygltf::Node node;
  node.name = "sun";
  node.rotation = xyzw(looking_along(-sun.to_sun));
  node.extensions[light_extension] = tinygltf::Value(tinygltf::Value::Object{{"light", tinygltf::Value(0)}});
  add_node(model, node);
}

tinygltf::Model empty_model() {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "seamline generate_scenes";
  model.buffers.emplace_back();
  model.scenes.emplace_back();
  model.defaultScene = 0;
  model.materials.push_back(diffuse({0.5, 0.5, 0.5}, "diffuse"));
  return model;
}

const unsigned char* accessor_bytes(const tinygltf::Model& model, const tinygltf::Accessor& accessor) {
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  return model.buffers.at(0).data.data() + view.byteOffset + accessor.byteOffset;
}

std::vector<Vector3d> read_vectors(const tinygltf::Model& model, int number) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(number));
  std::vector<float> values(3 * accessor.count);
  std::memcpy(values.data(), accessor_bytes(model, accessor), values.size() * sizeof(float));
  std::vector<Vector3d> vectors;
  for (std::size_t i = 0; i < values.size(); i += 3)
    vectors.emplace_back(values[i], values[i + 1], values[i + 2]);
  return vectors;
}

ScenePart read_part(const tinygltf::Model& model, const tinygltf::Node& node) {
  const tinygltf::Primitive& primitive =
      model.meshes.at(static_cast<std::size_t>(node.mesh)).primitives.at(0);
  ScenePart part{.name = node.name, .mesh = {}};
  const std::vector<double>& colour =
      model.materials.at(static_cast<std::size_t>(primitive.material)).pbrMetallicRoughness.baseColorFactor;
  part.albedo = {colour.at(0), colour.at(1), colour.at(2)};
  part.mesh.positions_m = read_vectors(model, primitive.attributes.at("POSITION"));
  part.mesh.normals = read_vectors(model, primitive.attributes.at("NORMAL"));
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(primitive.indices));
  part.mesh.triangles.resize(accessor.count / 3);
  std::memcpy(part.mesh.triangles.data(), accessor_bytes(model, accessor),
              accessor.count * sizeof(std::uint32_t));
  return part;
}

}  // namespace

void write_glb(const fs::path& path, const SceneContents& contents) {
  tinygltf::Model model = empty_model();
  for (const ScenePart& part : contents.parts) add_part(model, part);
  if (contents.camera) add_camera(model, *contents.camera);
  if (contents.sun) add_sun(model, *contents.sun);
  write_glb_file(path, model);
}

SceneContents read_glb(const fs::path& path) {
  tinygltf::Model model;
  tinygltf::TinyGLTF reader;
  std::string error;
  std::string warning;
  if (!reader.LoadBinaryFromFile(&model, &error, &warning, path.string()))
    throw input_error({.file = path.string(), .wanted = "a binary glTF 2.0 file", .found = error});
  SceneContents contents;
  for (const tinygltf::Node& node : model.nodes) {
    const auto rotation = [&] {
      return Eigen::Quaterniond(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    };
    if (node.mesh >= 0) contents.parts.push_back(read_part(model, node));
    if (node.camera >= 0) {
      const Vector3d position(node.translation[0], node.translation[1], node.translation[2]);
      contents.camera = SceneCamera{.position_m = position,
                                    .look_at_m = position - rotation() * Vector3d::UnitZ(),
                                    .vertical_fov_rad = model.cameras.at(0).perspective.yfov};
    }
    if (node.extensions.contains(light_extension))
      contents.sun = SceneSun{.to_sun = rotation() * Vector3d::UnitZ(),
                              .irradiance_w_m2 = model.lights.at(0).intensity / lux_per_w_m2};
  }
  return contents;
}

}  // namespace seamline::scenes
