#include "raytracer/material/material.h"

#include <algorithm>

#include "raytracer/material/reflectance_table.h"

namespace seamline::renderer {
namespace {

/// A black metal still mirrors at grazing angles; with f0 = 0 it would have no layer.
constexpr float least_f0 = 1e-6F;

Eigen::Vector2f of_set(const Texture& texture, const TextureCoordinates& uv) {
  return uv.sets[texture.uv_set];
}

/// The specular layer where there is no metal.
struct Dielectric {
  Rgb f0 = Rgb::Zero();
  float f90 = 1.0F;
};

Dielectric dielectric_of(const Material& material, const Rgb& colour, float strength) {
  return {.f0 = (material.dielectric_f0 * colour).min(1.0F) * strength, .f90 = strength};
}

Scatterer scatterer_of(const Rgb& base_colour, float metallic, float roughness,
                       const Dielectric& dielectric) {
  const float f90 = 1.0F - (1.0F - metallic) * (1.0F - dielectric.f90);
  const Rgb f0 = (1.0F - metallic) * dielectric.f0 + metallic * base_colour;
  return {.albedo = (1.0F - metallic) * base_colour,
          .f0 = f90 > 0.0F ? Rgb(f0.max(least_f0)) : Rgb(Rgb::Zero()),
          .alpha = std::clamp(roughness * roughness, least_alpha, 1.0F),
          .f90 = std::max(f90, least_f0)};
}

bool is_plain_dielectric(const Material& material) {
  return !material.specular_texture && !material.specular_colour_texture && material.specular == 1.0F &&
         (material.specular_colour == 1.0F).all();
}

}  // namespace

std::vector<const Texture*> textures_of(const Material& material) {
  std::vector<const Texture*> textures;
  for (const auto* texture :
       {&material.base_colour_texture, &material.emission_texture, &material.metallic_roughness_texture,
        &material.normal_texture, &material.specular_texture, &material.specular_colour_texture})
    if (*texture) textures.push_back(&**texture);
  return textures;
}

bool Material::is_uniform() const {
  return textures_of(*this).empty() && !alpha_cutoff;
}

MaterialValues material_at(const Material& material, const TextureCoordinates& uv) {
  const auto colour = [&](const std::optional<Texture>& texture, const Rgb& factor) -> Rgb {
    return texture ? Rgb(factor * look_up(*texture, of_set(*texture, uv)).head<3>()) : factor;
  };
  Rgb base_colour = colour(material.base_colour_texture, material.base_colour) * uv.colour.head<3>();
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
  Dielectric dielectric{.f0 = Rgb::Constant(material.dielectric_f0)};
  if (!is_plain_dielectric(material) || material.glossiness) {
    float strength = material.specular;
    if (const auto& texture = material.specular_texture)
      strength *= look_up(*texture, of_set(*texture, uv))[3];
    dielectric =
        dielectric_of(material, colour(material.specular_colour_texture, material.specular_colour), strength);
  }
  if (material.glossiness) {
    roughness = 1.0F - *material.glossiness;
    if (const auto& texture = material.specular_colour_texture)
      roughness = 1.0F - *material.glossiness * look_up(*texture, of_set(*texture, uv))[3];
    base_colour *= 1.0F - dielectric.f0.maxCoeff();
  }
  values.scatterer = scatterer_of(base_colour, metallic, roughness, dielectric);
  return values;
}

MaterialValues largest_values(const Material& material) {
  if (material.is_uniform()) return material_at(material, {});
  MaterialValues values{.scatterer = {.albedo = material.base_colour}, .emission = material.emission};
  if (material.has_layer)
    values.scatterer.f0 =
        material.base_colour.max(dielectric_of(material, material.specular_colour, material.specular).f0);
  return values;
}

bool cut_away(const Material& material, const TextureCoordinates& uv) {
  if (!material.alpha_cutoff) return false;
  float alpha = material.alpha * uv.colour[3];
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
