#include "raytracer/scene/gltf/gltf_material.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

using Value = tinygltf::Value;

constexpr const char* other_gloss = "KHR_materials_pbrSpecularGlossiness";

/// A part of a material that no model draws, unless its number, or each of its numbers, is 0.
struct UndrawnPart {
  const char* extension;
  const char* key;
  const char* what;
};
constexpr std::array undrawn_parts = {
    UndrawnPart{"KHR_materials_clearcoat", "clearcoatFactor", "clear coats"},
    UndrawnPart{"KHR_materials_sheen", "sheenColorFactor", "sheen"},
    UndrawnPart{"KHR_materials_iridescence", "iridescenceFactor", "iridescence"},
    UndrawnPart{"KHR_materials_anisotropy", "anisotropyStrength", "anisotropy of gloss"},
    UndrawnPart{"KHR_materials_dispersion", "dispersion", "dispersion"},
};
constexpr std::array light_through = {
    UndrawnPart{"KHR_materials_transmission", "transmissionFactor", "KHR_materials_transmission"},
    UndrawnPart{"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor",
                "KHR_materials_diffuse_transmission"},
};

const Value* extension_of(const tinygltf::Material& material, const char* name) {
  const auto found = material.extensions.find(name);
  return found == material.extensions.end() || !found->second.IsObject() ? nullptr : &found->second;
}

bool is_drawn_otherwise(const tinygltf::Material& material, const UndrawnPart& part) {
  const Value* extension = extension_of(material, part.extension);
  if (extension == nullptr || !extension->Has(part.key)) return false;  // the usual value of each is 0
  const Value& value = extension->Get(part.key);
  if (!value.IsArray()) return !value.IsNumber() || value.GetNumberAsDouble() != 0;
  for (std::size_t i = 0; i < value.ArrayLen(); ++i)
    if (!value.Get(i).IsNumber() || value.Get(i).GetNumberAsDouble() != 0) return true;
  return false;
}

float share(double value) {
  return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

/// A number of an extension of materials, or the usual one.
double extension_number(const Value& extension, const char* key, double usual) {
  if (!extension.Has(key) || !extension.Get(key).IsNumber()) return usual;
  const double number = extension.Get(key).GetNumberAsDouble();
  return std::isfinite(number) ? number : usual;
}

/// The numbers of an extension, or the usual one for each that is not there.
template <std::size_t size>
std::array<double, size> extension_numbers(const Value& extension, const char* key, double usual) {
  std::array<double, size> numbers{};
  numbers.fill(usual);
  if (!extension.Has(key) || !extension.Get(key).IsArray()) return numbers;
  const Value& value = extension.Get(key);
  for (std::size_t i = 0; i < std::min(size, value.ArrayLen()); ++i)
    if (value.Get(i).IsNumber() && std::isfinite(value.Get(i).GetNumberAsDouble()))
      numbers[i] = value.Get(i).GetNumberAsDouble();
  return numbers;
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

/// A texture that an extension names; its index is -1 where it names none.
tinygltf::TextureInfo texture_in(const Value& extension, const char* key) {
  tinygltf::TextureInfo info;
  if (!extension.Has(key)) return info;
  const Value& value = extension.Get(key);
  info.index = static_cast<int>(std::clamp(extension_number(value, "index", -1), -1.0, 1e9));
  info.texCoord = static_cast<int>(std::clamp(extension_number(value, "texCoord", 0), -1.0, 1e9));
  if (value.Has("extensions") && value.Get("extensions").IsObject())
    for (const std::string& name : value.Get("extensions").Keys())
      info.extensions[name] = value.Get("extensions").Get(name);
  return info;
}

}  // namespace

std::shared_ptr<const Material> GltfMaterials::read(int index, const std::string& where,
                                                    AlphaKind of_vertices) {
  const std::pair key(index, of_vertices);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  if (index < 0 || static_cast<std::size_t>(index) >= model_.materials.size())
    throw input_error({.file = file_.string(),
                       .field = where,
                       .wanted = "a material that exists",
                       .found = std::to_string(index)});
  const tinygltf::Material& from = model_.materials[index];
  return known_.emplace(key, read_new(from, fmt::format("materials[{}]", index), of_vertices)).first->second;
}

std::shared_ptr<const Material> GltfMaterials::read_new(const tinygltf::Material& from,
                                                        const std::string& field, AlphaKind of_vertices) {
  Material material;
  material.name = from.name;
  read_base(from, field, material);
  material.emission = read_emission(from, field);
  if (from.emissiveTexture.index >= 0 && (material.emission > 0.0F).any())
    material.emission_texture =
        textures_.read(from.emissiveTexture, Encoding::srgb, field + ".emissiveTexture");
  if (!read_alpha(from, field, of_vertices, material)) return nullptr;
  note_left_out(from);
  read_layer(from, field, material);
  return std::make_shared<const Material>(std::move(material));
}

void GltfMaterials::read_base(const tinygltf::Material& from, const std::string& field, Material& material) {
  const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
  std::vector<double> base = pbr.baseColorFactor;
  tinygltf::TextureInfo texture = pbr.baseColorTexture;
  if (const Value* extension = extension_of(from, other_gloss)) {
    const std::array<double, 4> diffuse = extension_numbers<4>(*extension, "diffuseFactor", 1);
    base.assign(diffuse.begin(), diffuse.end());
    texture = texture_in(*extension, "diffuseTexture");
  }
  if (base.size() >= 3) {
    material.base_colour = Rgb(base[0], base[1], base[2]).max(0.0F).min(1.0F);
    if (base.size() > 3) material.alpha = share(base[3]);
  }
  if (texture.index >= 0)
    material.base_colour_texture = textures_.read(texture, Encoding::srgb, field + ".baseColorTexture");
}

Rgb GltfMaterials::read_emission(const tinygltf::Material& from, const std::string& field) const {
  double strength = 1;
  if (const Value* extension = extension_of(from, "KHR_materials_emissive_strength");
      extension != nullptr && extension->Has("emissiveStrength"))
    strength = extension->Get("emissiveStrength").GetNumberAsDouble();
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

/// Whether surfaces of a material that light passes are drawn, as `Transparency` says.
bool GltfMaterials::keeps_half_transparent(const tinygltf::Material& from, const std::string& field,
                                           const char* what) {
  switch (transparency_) {
    case Transparency::refused:
      throw input_error(
          {.file = file_.string(),
           .field = field,
           .wanted = fmt::format("opaque surfaces or cut-outs (half-transparent ones are not rendered; "
                                 "{} {} is a way round)",
                                 request_name("transparent"), transparency_words),
           .found = fmt::format("{}, in the material \"{}\"", what, printable(from.name))});
    case Transparency::opaque:
      left_out_.insert("half-transparency (its surfaces are opaque)");
      return true;
    case Transparency::mask:
      left_out_.insert(
          fmt::format("half-transparency (its surfaces have holes where alpha is below {})", mask_cutoff));
      return true;
    case Transparency::left_out:
      left_out_.insert("half-transparent surfaces");
      return false;
  }
  return true;
}

/// False: the surfaces of the material are left out.
bool GltfMaterials::read_alpha(const tinygltf::Material& from, const std::string& field,
                               AlphaKind of_vertices, Material& material) {
  if (kind_ == MaterialModel::gltf)
    for (const UndrawnPart& part : light_through)
      if (is_drawn_otherwise(from, part) && !keeps_half_transparent(from, field, part.what)) return false;
  if (from.alphaMode == "MASK") {
    material.alpha_cutoff = static_cast<float>(from.alphaCutoff);
    return true;
  }
  if (from.alphaMode != "BLEND") return true;
  switch (more_transparent(of_vertices, alpha_kind(material.alpha, material.base_colour_texture))) {
    case AlphaKind::opaque:
      return true;
    case AlphaKind::cut_out:
      left_out_.insert(fmt::format("soft edges of alpha (cut-outs are masks at {})", mask_cutoff));
      material.alpha_cutoff = mask_cutoff;
      return true;
    case AlphaKind::partial:
      break;
  }
  if (!keeps_half_transparent(from, field, "alphaMode BLEND with half-transparent places")) return false;
  if (transparency_ == Transparency::mask) material.alpha_cutoff = mask_cutoff;
  return true;
}

void GltfMaterials::note_left_out(const tinygltf::Material& from) {
  for (const UndrawnPart& part : undrawn_parts)
    if (is_drawn_otherwise(from, part)) left_out_.insert(part.what);
  if (from.occlusionTexture.index >= 0) left_out_.insert("occlusion textures (light is traced)");
  if (from.extensions.contains("KHR_materials_unlit"))
    left_out_.insert("the unlit look of materials (they are lit as diffuse surfaces)");
  if (kind_ == MaterialModel::gltf) return;
  for (const UndrawnPart& part : light_through)
    if (is_drawn_otherwise(from, part)) left_out_.insert("light through surfaces");
}

void GltfMaterials::read_layer(const tinygltf::Material& from, const std::string& field, Material& material) {
  const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
  const Value* glossiness = extension_of(from, other_gloss);
  const bool textured = pbr.metallicRoughnessTexture.index >= 0;
  if (from.extensions.contains("KHR_materials_unlit")) return;  // says no more than a colour
  if (kind_ == MaterialModel::diffuse) {
    if (pbr.metallicFactor > 0 && glossiness == nullptr) left_out_of_diffuse_.insert("metals");
    if (pbr.roughnessFactor < 1 || textured || glossiness != nullptr) left_out_of_diffuse_.insert("gloss");
    if (from.normalTexture.index >= 0) left_out_of_diffuse_.insert("normal maps");
    return;
  }
  material.has_layer = true;
  if (glossiness != nullptr) {
    read_glossiness(*glossiness, field, material);
  } else {
    material.metallic = share(pbr.metallicFactor);
    material.roughness = share(pbr.roughnessFactor);
    if (textured)
      material.metallic_roughness_texture =
          textures_.read(pbr.metallicRoughnessTexture, Encoding::linear, field + ".metallicRoughnessTexture");
    read_dielectric(from, field, material);
  }
  if (from.normalTexture.index >= 0) {
    material.normal_texture =
        textures_.read(as_texture(from.normalTexture), Encoding::linear, field + ".normalTexture");
    material.normal_scale = static_cast<float>(from.normalTexture.scale);
  }
}

void GltfMaterials::read_dielectric(const tinygltf::Material& from, const std::string& field,
                                    Material& material) {
  if (const Value* extension = extension_of(from, "KHR_materials_ior")) {
    const double ior = extension_number(*extension, "ior", 1.5);
    if (ior != 0 && !(ior >= 1 && ior <= 1e6))
      throw input_error({.file = file_.string(),
                         .field = field + ".KHR_materials_ior.ior",
                         .wanted = "a refractive index of at least 1, or 0",
                         .found = fmt::format("{:g}", ior)});
    // 0 stands for one without end.
    const double root = ior == 0 ? 1 : (ior - 1) / (ior + 1);
    material.dielectric_f0 = static_cast<float>(root * root);
  }
  const Value* extension = extension_of(from, "KHR_materials_specular");
  if (extension == nullptr) return;
  const std::array<double, 3> colour = extension_numbers<3>(*extension, "specularColorFactor", 1);
  material.specular = share(extension_number(*extension, "specularFactor", 1));
  material.specular_colour = Rgb(colour[0], colour[1], colour[2]).max(0.0F).min(1e6F);
  if (const auto texture = texture_in(*extension, "specularTexture"); texture.index >= 0)
    material.specular_texture = textures_.read(texture, Encoding::linear, field + ".specularTexture");
  if (const auto texture = texture_in(*extension, "specularColorTexture"); texture.index >= 0)
    material.specular_colour_texture =
        textures_.read(texture, Encoding::srgb, field + ".specularColorTexture");
}

void GltfMaterials::read_glossiness(const Value& extension, const std::string& field, Material& material) {
  const std::array<double, 3> colour = extension_numbers<3>(extension, "specularFactor", 1);
  material.metallic = 0;
  material.dielectric_f0 = 1;
  material.specular_colour = Rgb(colour[0], colour[1], colour[2]).max(0.0F).min(1.0F);
  material.glossiness = share(extension_number(extension, "glossinessFactor", 1));
  if (const auto texture = texture_in(extension, "specularGlossinessTexture"); texture.index >= 0)
    material.specular_colour_texture =
        textures_.read(texture, Encoding::srgb, field + ".specularGlossinessTexture");
}

}  // namespace seamline::renderer
