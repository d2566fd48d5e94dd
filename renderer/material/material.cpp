#include "renderer/material/material.h"

#include <algorithm>

#include "renderer/material/reflectance_table.h"

namespace seamline::renderer {
namespace {

constexpr float dielectric_f0 = 0.04F;  ///< glTF's, of refractive index 1.5
/// A black metal still mirrors at grazing angles; with f0 = 0 it would have no layer.
constexpr float least_f0 = 1e-6F;

Eigen::Vector2f of_set(const Texture& texture, const TextureCoordinates& uv) {
  return uv[static_cast<std::size_t>(texture.uv_set)];
}

Scatterer scatterer_of(const Rgb& base_colour, float metallic, float roughness) {
  return {.albedo = (1.0F - metallic) * base_colour,
          .f0 = ((1.0F - metallic) * dielectric_f0 + metallic * base_colour).max(least_f0),
          .alpha = std::clamp(roughness * roughness, least_alpha, 1.0F)};
}

}  // namespace

MaterialValues material_at(const Material& material, const TextureCoordinates& uv) {
  const auto colour = [&](const std::optional<Texture>& texture, const Rgb& factor) -> Rgb {
    return texture ? Rgb(factor * look_up(*texture, of_set(*texture, uv)).head<3>()) : factor;
  };
  const Rgb base_colour = colour(material.base_colour_texture, material.base_colour);
  MaterialValues values;
  values.emission = colour(material.emission_texture, material.emission);
  if (!material.has_layer) {
    values.scatterer.albedo = base_colour;
    return values;
  }
  float metallic = material.metallic, roughness = material.roughness;
  if (const auto& texture = material.metallic_roughness_texture) {
    const Eigen::Array4f found = look_up(*texture, of_set(*texture, uv));
    roughness *= found[1];
    metallic *= found[2];
  }
  values.scatterer = scatterer_of(base_colour, metallic, roughness);
  return values;
}

MaterialValues largest_values(const Material& material) {
  if (material.is_uniform()) return material_at(material, {});
  MaterialValues values{.scatterer = {.albedo = material.base_colour}, .emission = material.emission};
  if (material.has_layer) values.scatterer.f0 = material.base_colour.max(dielectric_f0);
  return values;
}

bool cut_away(const Material& material, const TextureCoordinates& uv) {
  if (!material.alpha_cutoff) return false;
  float alpha = material.alpha;
  if (const auto& texture = material.base_colour_texture; texture && texture->has_alpha())
    alpha *= look_up(*texture, of_set(*texture, uv))[3];
  return alpha < *material.alpha_cutoff;
}

Eigen::Vector3f mapped_normal(const Material& material, const TextureCoordinates& uv,
                              const Eigen::Vector3f& normal, const Eigen::Vector3f& tangent,
                              const Eigen::Vector3f& bitangent) {
  if (!material.normal_texture) return normal;
  const Texture& texture = *material.normal_texture;
  const Eigen::Array3f found = look_up(texture, of_set(texture, uv)).head<3>() * 2.0F - 1.0F;
  const Eigen::Vector3f mapped =
      material.normal_scale * (found[0] * tangent + found[1] * bitangent) + found[2] * normal;
  const float length = mapped.norm();
  return length > 0.0F ? Eigen::Vector3f(mapped / length) : normal;
}

}  // namespace seamline::renderer
