// The only file of this folder that includes tinygltf.
#include "scenes/shapes/glb_file.h"

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <cstring>
#include <map>
#include <span>

#include "scenes/shapes/pattern.h"
#include "support/arithmetic/units.h"
#include "support/files/atomic_file.h"
#include "support/files/gltf_writing.h"
#include "support/files/temporary_folder.h"
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

int add_picture(tinygltf::Model& model, const std::string& name, const ByteImage& picture) {
  const TemporaryFolder folder;
  write_png(folder / "picture.png", picture);
  const std::string bytes = read_file(folder / "picture.png");
  std::vector<unsigned char>& buffer = model.buffers.at(0).data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = buffer.size();
  view.byteLength = bytes.size();
  buffer.insert(buffer.end(), bytes.begin(), bytes.end());
  while (buffer.size() % 4 != 0) buffer.push_back(0);  // the next one's numbers
  model.bufferViews.push_back(view);
  tinygltf::Image image;
  image.name = name;
  image.mimeType = "image/png";
  image.bufferView = static_cast<int>(model.bufferViews.size()) - 1;
  model.images.push_back(image);
  tinygltf::Texture texture;
  texture.source = static_cast<int>(model.images.size()) - 1;
  texture.sampler = 0;
  model.textures.push_back(texture);
  return static_cast<int>(model.textures.size()) - 1;
}

/// A pattern's pictures in a file: the numbers of its textures.
struct WrittenPattern {
  double side_m = 1;
  int colour = -1, normal = -1, gloss = -1;
};

/// Materials and patterns of a file, each written once.
class Materials {
 public:
  explicit Materials(tinygltf::Model& model) : model_(model), surfaces_(model.materials.size()) {}

  const WrittenPattern& pattern(const std::string& name) {
    if (const auto known = patterns_.find(name); known != patterns_.end()) return known->second;
    if (model_.samplers.empty()) {
      tinygltf::Sampler sampler;
      sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_REPEAT;
      model_.samplers.push_back(sampler);
    }
    const PatternPictures made = make_pattern(name);
    return patterns_
        .emplace(name, WrittenPattern{made.side_m, add_picture(model_, name, made.colour),
                                      add_picture(model_, name + "_normal", made.normal),
                                      add_picture(model_, name + "_gloss", made.gloss)})
        .first->second;
  }

  /// The material of a part, which is added where there is none.
  int of(const ScenePart& part) {
    const std::vector<double> colour = {part.albedo[0], part.albedo[1], part.albedo[2], 1.0};
    SceneSurface wanted = part.surface;
    wanted.pattern_m.clear();
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
      if (model_.materials[i].pbrMetallicRoughness.baseColorFactor == colour && same(surfaces_[i], wanted))
        return static_cast<int>(i);
    tinygltf::Material material = diffuse(part.albedo, part.name);
    material.pbrMetallicRoughness.metallicFactor = wanted.metallic;
    material.pbrMetallicRoughness.roughnessFactor = wanted.roughness;
    add_emission(material, wanted);
    if (!wanted.pattern.empty()) {
      const WrittenPattern& written = pattern(wanted.pattern);
      material.pbrMetallicRoughness.baseColorTexture.index = written.colour;
      material.pbrMetallicRoughness.metallicRoughnessTexture.index = written.gloss;
      material.normalTexture.index = written.normal;
    }
    model_.materials.push_back(material);
    surfaces_.push_back(wanted);
    return static_cast<int>(model_.materials.size()) - 1;
  }

 private:
  static bool same(const SceneSurface& a, const SceneSurface& b) {
    return a.roughness == b.roughness && a.metallic == b.metallic &&
           a.emission_w_m2_sr == b.emission_w_m2_sr && a.pattern == b.pattern;
  }
  void add_emission(tinygltf::Material& material, const SceneSurface& surface) {
    const auto& emission = surface.emission_w_m2_sr;
    const double strength = std::max({emission[0], emission[1], emission[2]});
    if (!(strength > 0)) return;
    material.emissiveFactor = {emission[0] / strength, emission[1] / strength, emission[2] / strength};
    material.extensions["KHR_materials_emissive_strength"] =
        tinygltf::Value(tinygltf::Value::Object{{"emissiveStrength", tinygltf::Value(strength)}});
    if (model_.extensionsUsed.empty() || model_.extensionsUsed.back() != "KHR_materials_emissive_strength")
      model_.extensionsUsed.emplace_back("KHR_materials_emissive_strength");
  }

  tinygltf::Model& model_;
  std::vector<SceneSurface> surfaces_;  ///< one a material
  std::map<std::string, WrittenPattern> patterns_;
};

/// Two numbers a vertex, in sides of the pattern.
int add_pattern_places(tinygltf::Model& model, const SceneSurface& surface, double side_m) {
  std::vector<float> values;
  for (const Eigen::Vector2d& place_m : surface.pattern_m)
    for (const double along_m : place_m) values.push_back(static_cast<float>(along_m / side_m));
  return add_accessor(model, std::as_bytes(std::span(values)),
                      {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, TINYGLTF_TARGET_ARRAY_BUFFER});
}

void add_part(tinygltf::Model& model, Materials& materials, const ScenePart& part) {
  std::vector<std::uint32_t> indices;
  for (const auto& triangle : part.mesh.triangles)
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = materials.of(part);
  primitive.attributes["POSITION"] = add_vectors(model, part.mesh.positions_m, true);
  primitive.attributes["NORMAL"] = add_vectors(model, part.mesh.normals, false);
  if (!part.surface.pattern.empty())
    primitive.attributes["TEXCOORD_0"] =
        add_pattern_places(model, part.surface, materials.pattern(part.surface.pattern).side_m);
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

/// A white light at `node`.
void add_light(tinygltf::Model& model, tinygltf::Node node, const std::string& type, double intensity) {
  tinygltf::Light light;
  light.name = node.name;
  light.type = type;
  light.color = {1, 1, 1};
  light.intensity = intensity;
  const int number = static_cast<int>(model.lights.size());
  model.lights.push_back(light);
  node.extensions[light_extension] =
      tinygltf::Value(tinygltf::Value::Object{{"light", tinygltf::Value(number)}});
  add_node(model, node);
}

void add_sun(tinygltf::Model& model, const SceneSun& sun) {
  tinygltf::Node node;
  node.name = "sun";
  node.rotation = xyzw(looking_along(-sun.to_sun));
  add_light(model, node, "directional", lux_per_w_m2 * sun.irradiance_w_m2);
}

void add_lamp(tinygltf::Model& model, const SceneLamp& lamp) {
  tinygltf::Node node;
  node.name = "lamp";
  node.translation = {lamp.position_m.x(), lamp.position_m.y(), lamp.position_m.z()};
  add_light(model, node, "point", lux_per_w_m2 * lamp.intensity_w_sr);
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

ScenePart patterned(const ScenePart& part, const std::string& pattern) {
  ScenePart laid = part;
  laid.mesh = {};
  laid.surface.pattern = pattern;
  laid.surface.pattern_m.clear();
  for (const auto& triangle : part.mesh.triangles) {
    const auto at = [&](std::size_t corner) { return part.mesh.positions_m[triangle[corner]]; };
    const Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0));
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const auto first = static_cast<std::uint32_t>(laid.mesh.positions_m.size());
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vector3d place = at(corner);
      laid.mesh.positions_m.push_back(place);
      laid.mesh.normals.push_back(part.mesh.normals[triangle[corner]]);
      // Along x (or z, of what faces x), and down or towards the viewer: a picture's rows run down.
      laid.surface.pattern_m.emplace_back(axis == 0 ? place.z() : place.x(),
                                          axis == 1 ? place.z() : -place.y());
    }
    laid.mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return laid;
}

void write_glb(const fs::path& path, const SceneContents& contents) {
  tinygltf::Model model = empty_model();
  Materials materials(model);
  for (const ScenePart& part : contents.parts) add_part(model, materials, part);
  if (contents.camera) add_camera(model, *contents.camera);
  if (contents.sun) add_sun(model, *contents.sun);
  if (contents.lamp) add_lamp(model, *contents.lamp);
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
    if (node.name == "lamp")
      contents.lamp = SceneLamp{.position_m = {node.translation[0], node.translation[1], node.translation[2]},
                                .intensity_w_sr = model.lights.back().intensity / lux_per_w_m2};
    else if (node.extensions.contains(light_extension))
      contents.sun = SceneSun{.to_sun = rotation() * Vector3d::UnitZ(),
                              .irradiance_w_m2 = model.lights.at(0).intensity / lux_per_w_m2};
  }
  return contents;
}

}  // namespace seamline::scenes
