#include "renderer/scene/gltf_material.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline::renderer {
namespace {

/// A key of a material extension that changes the picture unless its number, or each of its numbers, is this.
struct ChangingKey {
  const char* extension;
  const char* key;
  double harmless;
  const char* what;
};
constexpr std::array<ChangingKey, 10> changing_keys = {{
    {"KHR_materials_clearcoat", "clearcoatFactor", 0, "a clear coat"},
    {"KHR_materials_transmission", "transmissionFactor", 0, "light through the surface"},
    {"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor", 0, "light through the surface"},
    {"KHR_materials_sheen", "sheenColorFactor", 0, "sheen"},
    {"KHR_materials_ior", "ior", 1.5, "a refractive index other than 1.5"},
    {"KHR_materials_specular", "specularFactor", 1, "a layer of its own strength"},
    {"KHR_materials_specular", "specularColorFactor", 1, "a layer of its own colour"},
    {"KHR_materials_iridescence", "iridescenceFactor", 0, "iridescence"},
    {"KHR_materials_anisotropy", "anisotropyStrength", 0, "anisotropy"},
    {"KHR_materials_pbrSpecularGlossiness", nullptr, 0, "another model of gloss"},
}};

bool is_harmless(const tinygltf::Value& extension, const ChangingKey& changing) {
  if (changing.key == nullptr) return false;
  if (!extension.Has(changing.key)) return true;  // the usual value of each is the harmless one
  const tinygltf::Value& value = extension.Get(changing.key);
  if (!value.IsArray()) return value.IsNumber() && value.GetNumberAsDouble() == changing.harmless;
  for (std::size_t i = 0; i < value.ArrayLen(); ++i)
    if (!value.Get(i).IsNumber() || value.Get(i).GetNumberAsDouble() != changing.harmless) return false;
  return true;
}

/// Extensions of a material that are not rendered and would be seen.
std::vector<ChangingKey> changing_extensions(const tinygltf::Material& material) {
  std::vector<ChangingKey> found;
  for (const ChangingKey& changing : changing_keys)
    if (const auto extension = material.extensions.find(changing.extension);
        extension != material.extensions.end() && !is_harmless(extension->second, changing))
      found.push_back(changing);
  return found;
}

float share(double value) {
  return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

/// Normal and occlusion textures have classes of their own in the library.
template <class Info>
tinygltf::TextureInfo as_texture(const Info& from) {
  tinygltf::TextureInfo info;
  info.index = from.index;
  info.texCoord = from.texCoord;
  info.extensions = from.extensions;
  return info;
}

/// The least alpha that a picture holds.
float least_alpha_of(const Texture& texture) {
  if (!texture.has_alpha()) return 1.0F;
  const ByteImage& picture = *texture.picture;
  const auto channels = static_cast<std::size_t>(picture.channels);
  std::uint8_t least = 255;
  for (std::size_t at = channels - 1; at < picture.values.size(); at += channels)
    least = std::min(least, picture.values[at]);
  return static_cast<float>(least) / 255.0F;
}

}  // namespace

std::shared_ptr<const Material> GltfMaterials::read(int index, const std::string& where) {
  if (const auto found = known_.find(index); found != known_.end()) return found->second;
  if (index < 0 || static_cast<std::size_t>(index) >= model_.materials.size())
    throw input_error({.file = file_.string(),
                       .field = where,
                       .wanted = "a material that exists",
                       .found = std::to_string(index)});
  const tinygltf::Material& from = model_.materials[static_cast<std::size_t>(index)];
  auto material = std::make_shared<const Material>(read_new(from, fmt::format("materials[{}]", index)));
  return known_.emplace(index, std::move(material)).first->second;
}

Material GltfMaterials::read_new(const tinygltf::Material& from, const std::string& field) {
  const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
  Material material;
  material.name = from.name;
  if (const std::vector<double>& base = pbr.baseColorFactor; base.size() >= 3) {
    material.base_colour = Rgb(base[0], base[1], base[2]).max(0.0F).min(1.0F);
    if (base.size() > 3) material.alpha = share(base[3]);
  }
  if (pbr.baseColorTexture.index >= 0)
    material.base_colour_texture =
        textures_.read(pbr.baseColorTexture, Encoding::srgb, field + ".baseColorTexture");
  material.emission = read_emission(from, field);
  if (from.emissiveTexture.index >= 0 && (material.emission > 0.0F).any())
    material.emission_texture =
        textures_.read(from.emissiveTexture, Encoding::srgb, field + ".emissiveTexture");
  read_alpha(from, field, material);
  read_layer(from, field, material);
  return material;
}

Rgb GltfMaterials::read_emission(const tinygltf::Material& from, const std::string& field) const {
  double strength = 1;
  if (const auto found = from.extensions.find("KHR_materials_emissive_strength");
      found != from.extensions.end() && found->second.Has("emissiveStrength"))
    strength = found->second.Get("emissiveStrength").GetNumberAsDouble();
  if (from.emissiveFactor.size() != 3) return Rgb::Zero();
  // Both are the file's, and so may be anything; so may their product.
  for (const double channel : from.emissiveFactor)
    if (!(channel >= 0 && channel <= limits::strongest_light && strength >= 0 &&
          strength <= limits::strongest_light && channel * strength <= limits::strongest_light))
      throw input_error({.file = file_.string(),
                         .field = field + ".emissiveFactor",
                         .wanted = fmt::format("light from 0 to {:g} W/m2/sr", limits::strongest_light),
                         .found = fmt::format("{:g} times {:g}", channel, strength)});
  return Rgb(from.emissiveFactor[0], from.emissiveFactor[1], from.emissiveFactor[2]) *
         static_cast<float>(strength);
}

void GltfMaterials::read_alpha(const tinygltf::Material& from, const std::string& field,
                               Material& material) const {
  if (from.alphaMode == "MASK") {
    material.alpha_cutoff = static_cast<float>(from.alphaCutoff);
    return;
  }
  if (from.alphaMode != "BLEND") return;
  const float least =
      material.alpha * (material.base_colour_texture ? least_alpha_of(*material.base_colour_texture) : 1.0F);
  if (least < 1.0F)
    throw input_error(
        {.file = file_.string(),
         .field = field + ".alphaMode",
         .wanted = "OPAQUE or MASK (half-transparent surfaces are not rendered)",
         .found = fmt::format("BLEND, with alpha down to {:.2g}, in the material \"{}\"", least, from.name)});
}

void GltfMaterials::read_layer(const tinygltf::Material& from, const std::string& field, Material& material) {
  const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
  const bool textured = pbr.metallicRoughnessTexture.index >= 0;
  const std::vector<ChangingKey> changing = changing_extensions(from);
  if (from.extensions.contains("KHR_materials_unlit")) return;  // says no more than a colour
  if (kind_ == MaterialModel::diffuse) {
    if (pbr.metallicFactor > 0) left_out_.insert("metals");
    if (pbr.roughnessFactor < 1 || textured) left_out_.insert("gloss");
    if (from.normalTexture.index >= 0) left_out_.insert("normal maps");
    for (const ChangingKey& one : changing) left_out_.insert(one.extension);
    return;
  }
  if (!changing.empty())
    throw input_error({.file = file_.string(),
                       .field = field,
                       .wanted = "a material of metal, roughness and normals only",
                       .found = fmt::format("{} ({}), in the material \"{}\"", changing.front().extension,
                                            changing.front().what, from.name)});
  material.has_layer = true;
  material.metallic = share(pbr.metallicFactor);
  material.roughness = share(pbr.roughnessFactor);
  if (textured)
    material.metallic_roughness_texture =
        textures_.read(pbr.metallicRoughnessTexture, Encoding::linear, field + ".metallicRoughnessTexture");
  if (from.normalTexture.index >= 0) {
    material.normal_texture =
        textures_.read(as_texture(from.normalTexture), Encoding::linear, field + ".normalTexture");
    material.normal_scale = static_cast<float>(from.normalTexture.scale);
  }
}

}  // namespace seamline::renderer
