#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <numbers>
#include <optional>

#include "raytracer/material/hemisphere.h"
#include "support/arithmetic/colour.h"

namespace seamline::renderer {

/// What a point of a surface does with light: a diffuse base under a rough specular layer (documentation/
/// developers/design_of_parts.md, section 10). With f0 = 0 there is no layer, and the surface is Lambert's.
struct Scatterer {
  Rgb albedo = Rgb::Zero();  ///< of the diffuse base, 0 to 1
  Rgb f0 = Rgb::Zero();      ///< reflectance of the layer at normal incidence, 0 to 1
  float alpha = 1.0F;        ///< GGX's width, the square of roughness; from `least_alpha` to 1, else clamped
  float f90 = 1.0F;          ///< reflectance of the layer along the horizon, at least f0
};

/// Whether a surface has a specular layer.
[[nodiscard]] inline bool is_glossy(const Scatterer& scatterer) {
  return (scatterer.f0 > 0.0F).any();
}

/// The share of a light's irradiance across its own direction that goes on to the viewer, per steradian: BSDF
/// times cosine. All directions are unit and point away from the surface; 0 where the light is below the
/// horizon of `normal`, and on glossy surfaces where the viewer is.
[[nodiscard]] Rgb scattered_share(const Scatterer& scatterer, const Eigen::Vector3f& normal,
                                  const Eigen::Vector3f& to_viewer, const Eigen::Vector3f& to_light);

/// How often `sample_scattering` takes `direction`, per steradian. Over the sphere it sums up to 1 less the
/// share of samples that have no direction.
[[nodiscard]] float scattering_density(const Scatterer& scatterer, const Eigen::Vector3f& normal,
                                       const Eigen::Vector3f& to_viewer, const Eigen::Vector3f& direction);

/// Both of the above for less than twice the time; the same numbers.
struct ScatteredLight {
  Rgb share = Rgb::Zero();
  Rgb specular = Rgb::Zero();  ///< what of it comes off the layer, after any number of reflections
  float density = 0.0F;
};
[[nodiscard]] ScatteredLight scattered_light(const Scatterer& scatterer, const Eigen::Vector3f& normal,
                                             const Eigen::Vector3f& to_viewer,
                                             const Eigen::Vector3f& direction);

struct ScatteredDirection {
  Eigen::Vector3f direction = Eigen::Vector3f::Zero();  ///< unit, above the horizon of the normal
  Rgb weight = Rgb::Zero();                             ///< scattered_share / density
  Rgb specular = Rgb::Zero();                           ///< what of the weight is of the layer
  float density = 0.0F;                                 ///< scattering_density, of all lobes together
  bool specular_lobe = false;                           ///< taken from one reflection on the layer
};

/// A direction that light of a viewer's ray goes on in, by `point` of [0, 1)^2; its first number chooses the
/// lobe, too. None where one reflection leads below the surface: that light is lost. Lambert's surfaces take
/// `cosine_weighted` of the point, with the albedo as weight.
[[nodiscard]] std::optional<ScatteredDirection> sample_scattering(const Scatterer& scatterer,
                                                                  const Eigen::Vector3f& normal,
                                                                  const Eigen::Vector3f& to_viewer,
                                                                  const Eigen::Array2f& point);

/// Of glossy surfaces only; the functions above call them.
namespace glossy {
[[nodiscard]] ScatteredLight light(const Scatterer& scatterer, const Eigen::Vector3f& normal,
                                   const Eigen::Vector3f& to_viewer, const Eigen::Vector3f& direction);
[[nodiscard]] std::optional<ScatteredDirection> sample(const Scatterer& scatterer,
                                                       const Eigen::Vector3f& normal,
                                                       const Eigen::Vector3f& to_viewer,
                                                       const Eigen::Array2f& point);
}  // namespace glossy

inline ScatteredLight scattered_light(const Scatterer& scatterer, const Eigen::Vector3f& normal,
                                      const Eigen::Vector3f& to_viewer, const Eigen::Vector3f& direction) {
  if (is_glossy(scatterer)) return glossy::light(scatterer, normal, to_viewer, direction);
  const float density = std::numbers::inv_pi_v<float> * std::max(0.0F, normal.dot(direction));
  return {scatterer.albedo * density, Rgb::Zero(), density};
}

inline Rgb scattered_share(const Scatterer& scatterer, const Eigen::Vector3f& normal,
                           const Eigen::Vector3f& to_viewer, const Eigen::Vector3f& to_light) {
  return scattered_light(scatterer, normal, to_viewer, to_light).share;
}

inline float scattering_density(const Scatterer& scatterer, const Eigen::Vector3f& normal,
                                const Eigen::Vector3f& to_viewer, const Eigen::Vector3f& direction) {
  return scattered_light(scatterer, normal, to_viewer, direction).density;
}

inline std::optional<ScatteredDirection> sample_scattering(const Scatterer& scatterer,
                                                           const Eigen::Vector3f& normal,
                                                           const Eigen::Vector3f& to_viewer,
                                                           const Eigen::Array2f& point) {
  if (is_glossy(scatterer)) return glossy::sample(scatterer, normal, to_viewer, point);
  const Eigen::Vector3f direction = cosine_weighted(normal, point);
  return ScatteredDirection{direction, scatterer.albedo, Rgb::Zero(),
                            std::numbers::inv_pi_v<float> * std::max(0.0F, normal.dot(direction)), false};
}

}  // namespace seamline::renderer
