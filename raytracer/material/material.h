#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/material/scattering.h"
#include "raytracer/material/texture.h"
#include "support/arithmetic/colour.h"

namespace seamline::renderer {

/// A material of glTF 2.0, metallic-roughness, as far as it is rendered. A texture multiplies the number
/// beside it. Both sides of every surface are seen, whatever `doubleSided` says.
struct Material {
  std::string name = {};
  Rgb base_colour = Rgb::Ones();
  float alpha = 1.0F;                               ///< looked at only where `alpha_cutoff` is
  std::optional<Texture> base_colour_texture = {};  ///< sRGB, and its alpha
  std::optional<float> alpha_cutoff = {};           ///< where alpha is below it, there is no surface
  Rgb emission = Rgb::Zero();                       ///< radiance, both sides
  std::optional<Texture> emission_texture = {};     ///< sRGB
  /// Without: everything scatters diffusely, the base colour is the albedo, and nothing below is looked at.
  bool has_layer = false;
  float metallic = 1.0F, roughness = 1.0F;
  std::optional<Texture> metallic_roughness_texture = {};  ///< blue and green
  std::optional<Texture> normal_texture = {};  ///< tangent space: x right, y up, z out of the picture
  float normal_scale = 1.0F;                   ///< of x and y
  /// The layer of what is no metal (KHR_materials_ior and KHR_materials_specular): f0 = min(reflectance at
  /// normal incidence times colour, 1) times strength, and f90 is the strength.
  float dielectric_f0 = 0.04F;
  Rgb specular_colour = Rgb::Ones();
  float specular = 1.0F;
  std::optional<Texture> specular_texture = {};         ///< its alpha
  std::optional<Texture> specular_colour_texture = {};  ///< sRGB
  /// Of KHR_materials_pbrSpecularGlossiness, whose roughness is 1 less this times the alpha of
  /// `specular_colour_texture`, and whose base colour is scaled by what the strongest channel of f0 leaves.
  std::optional<float> glossiness = {};

  /// Whether it is the same everywhere on a surface.
  [[nodiscard]] bool is_uniform() const;
};

/// The textures that a material has.
[[nodiscard]] std::vector<const Texture*> textures_of(const Material& material);

/// What a material is looked up by at a point of a mesh.
struct TextureCoordinates {
  std::array<Eigen::Vector2f, 2> sets = {Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()};
  Eigen::Array4f colour = Eigen::Array4f::Ones();  ///< of the vertices: red, green, blue, alpha
};

/// What a material is at one point.
struct MaterialValues {
  Scatterer scatterer;
  Rgb emission = Rgb::Zero();
};
[[nodiscard]] MaterialValues material_at(const Material& material, const TextureCoordinates& uv);

/// What no point of a material exceeds in albedo, f0 and emission; of a uniform one, what it is.
[[nodiscard]] MaterialValues largest_values(const Material& material);

/// Whether there is a hole in the surface: alpha below the cutoff.
[[nodiscard]] bool cut_away(const Material& material, const TextureCoordinates& uv);

/// The normal that the normal texture says, in a frame of unit vectors; `normal` where it says none.
[[nodiscard]] Eigen::Vector3f mapped_normal(const Material& material, const TextureCoordinates& uv,
                                            const Eigen::Vector3f& normal, const Eigen::Vector3f& tangent,
                                            const Eigen::Vector3f& bitangent);

}  // namespace seamline::renderer
