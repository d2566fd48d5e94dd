#include "raytracer/material/scattering.h"

#include <cmath>

#include "raytracer/material/microfacets.h"
#include "raytracer/material/reflectance_table.h"

namespace seamline::renderer::glossy {
namespace {

constexpr float inv_pi = std::numbers::inv_pi_v<float>;
constexpr float below_one = 0x1.fffffep-1F;

/// Of a glossy surface, what depends on the viewer alone.
///
/// One reflection is D F V with Schlick's F = f0 + (f90 - f0)(1 - c)^5. What it loses, 1 - E, leaves after
/// more reflections as (1 - E(mu_o)) (1 - E(mu_i)) / (pi mean(1 - E)), of which Fresnel's losses leave F_m^2
/// E_m / (1 - F_m (1 - E_m)), F_m = f0 + (f90 - f0) / 21 being the mean of F (Kulla and Conty, SIGGRAPH
/// course "Revisiting Physically Based Shading at Imageworks", 2017). E_s, the share that both send back, is
/// kept from the base, on the way in and on the way out:
/// albedo (1 - E_s(mu_o)) (1 - E_s(mu_i)) / (pi mean(1 - E_s)).
/// So every term is the same with viewer and light exchanged, and what the terms send back of mu_o adds up to
/// E_s(mu_o) + albedo (1 - E_s(mu_o)).
struct Seen {
  float mu_o, alpha;
  ReflectanceRow row;
  Rgb f0;
  float f90;
  Rgb kept_after_more;                   ///< F_m^2 E_m / (1 - F_m (1 - E_m))
  float lost_o;                          ///< 1 - E(mu_o)
  Rgb more_scale;                        ///< of (1 - E(mu_i)) mu_i
  Rgb base_scale;                        ///< of (1 - E_s(mu_i)) mu_i
  float one_lobe, more_lobe, base_lobe;  ///< how often each is sampled; together 1, or all 0

  /// 1 - E_s for a cosine whose 1 - E and mean of (1 - c)^5 are known.
  [[nodiscard]] Rgb passed(float lost, float schlick) const {
    return (1.0F - one_reflection(lost, schlick) - lost * kept_after_more).max(0.0F);
  }
  [[nodiscard]] Rgb one_reflection(float lost, float schlick) const {
    return (1.0F - lost) * (f0 + (f90 - f0) * schlick);
  }
};

Seen seen_from(const Scatterer& scatterer, float mu_o) {
  Seen seen;
  seen.mu_o = mu_o;
  seen.alpha = std::clamp(scatterer.alpha, least_alpha, 1.0F);
  seen.row = reflectance_row(reflectance_table(), seen.alpha);
  seen.f0 = scatterer.f0;
  seen.f90 = scatterer.f90;
  const float mean_lost = seen.row.mean_lost;
  const Rgb mean_f = seen.f0 + (seen.f90 - seen.f0) * (1.0F / 21.0F);
  seen.kept_after_more = mean_f * mean_f * (1.0F - mean_lost) / (1.0F - mean_f * mean_lost);
  seen.lost_o = seen.row.lost(mu_o);
  const float schlick_o = seen.row.schlick(mu_o);
  const Rgb passed_o = seen.passed(seen.lost_o, schlick_o);
  const Rgb mean_passed =
      (1.0F - (seen.f0 * (1.0F - mean_lost) + (seen.f90 - seen.f0) * seen.row.mean_schlick) -
       mean_lost * seen.kept_after_more)
          .max(1e-6F);
  const Rgb more = seen.lost_o * seen.kept_after_more;
  const Rgb base = scatterer.albedo * passed_o;
  seen.more_scale = more * (inv_pi / mean_lost);
  seen.base_scale = base * inv_pi / mean_passed;
  const float one = seen.one_reflection(seen.lost_o, schlick_o).sum();
  const float all = one + more.sum() + base.sum();
  const float scale = all > 0.0F ? 1.0F / all : 0.0F;
  seen.one_lobe = one * scale;
  seen.more_lobe = more.sum() * scale;
  seen.base_lobe = base.sum() * scale;
  return seen;
}

ScatteredLight scattered(const Seen& seen, const Eigen::Vector3f& normal, const Eigen::Vector3f& to_viewer,
                         const Eigen::Vector3f& direction) {
  const float mu_i = normal.dot(direction);
  if (!(mu_i > 0.0F)) return {};
  const float lost_i = seen.row.lost(mu_i);
  ScatteredLight light;
  light.specular = seen.more_scale * (lost_i * mu_i);
  light.share = light.specular + seen.base_scale * seen.passed(lost_i, seen.row.schlick(mu_i)) * mu_i;
  light.density = (seen.more_lobe * seen.row.lost_density(mu_i) + seen.base_lobe) * (inv_pi * mu_i);
  const Eigen::Vector3f sum = to_viewer + direction;
  const float squared_length = sum.squaredNorm();
  if (!(squared_length > 1e-12F))
    return light;  // both along the horizon, opposite: no mirror's normal is there
  const Eigen::Vector3f mirror = sum / std::sqrt(squared_length);
  // The sine from what lies across the normal: near it, 1 - cosine^2 would be all rounding.
  const float squared_sine = std::min(1.0F, (mirror - mirror.dot(normal) * normal).squaredNorm());
  const float density = mirror_density(squared_sine, seen.alpha);
  const float weight = schlick_weight(0.5F * std::sqrt(squared_length));
  const Rgb fresnel = seen.f0 + (seen.f90 - seen.f0) * weight;
  const Rgb one = fresnel * (density * visibility(seen.mu_o, mu_i, seen.alpha) * mu_i);
  light.share += one;
  light.specular += one;
  light.density += seen.one_lobe * visible_density(density, seen.mu_o, seen.alpha);
  return light;
}

/// The direction that a sample of one reflection leads to; may be below the surface.
Eigen::Vector3f mirrored(const Seen& seen, const Eigen::Matrix3f& axes, const Eigen::Vector3f& to_viewer,
                         const Eigen::Array2f& point) {
  const Eigen::Vector3f from = axes.transpose() * to_viewer;
  const Eigen::Vector3f mirror = visible_mirror<float>(from, seen.alpha, point[1], point[0]);
  return axes * (2.0F * from.dot(mirror) * mirror - from).normalized();
}

/// A direction of this cosine.
Eigen::Vector3f around(const Eigen::Matrix3f& axes, float cosine, float turn) {
  const float sine = std::sqrt(std::max(0.0F, (1.0F - cosine) * (1.0F + cosine)));
  const float angle = 2.0F * std::numbers::pi_v<float> * turn;
  return axes * Eigen::Vector3f(sine * std::cos(angle), sine * std::sin(angle), cosine);
}

}  // namespace

ScatteredLight light(const Scatterer& scatterer, const Eigen::Vector3f& normal,
                     const Eigen::Vector3f& to_viewer, const Eigen::Vector3f& direction) {
  const float mu_o = normal.dot(to_viewer);
  if (!(mu_o > 0.0F)) return {};
  return scattered(seen_from(scatterer, mu_o), normal, to_viewer, direction);
}

std::optional<ScatteredDirection> sample(const Scatterer& scatterer, const Eigen::Vector3f& normal,
                                         const Eigen::Vector3f& to_viewer, const Eigen::Array2f& point) {
  const float mu_o = normal.dot(to_viewer);
  if (!(mu_o > 0.0F)) return std::nullopt;
  const Seen seen = seen_from(scatterer, mu_o);
  const Eigen::Matrix3f axes = local_axes(normal);
  ScatteredDirection out;
  float first = point[0];
  if (first < seen.one_lobe) {
    out.specular_lobe = true;
    out.direction = mirrored(seen, axes, to_viewer, {std::min(first / seen.one_lobe, below_one), point[1]});
  } else if ((first -= seen.one_lobe) < seen.more_lobe) {
    out.direction = around(axes, seen.row.lost_cosine(std::min(first / seen.more_lobe, below_one)), point[1]);
  } else if (seen.base_lobe > 0.0F) {
    first = std::clamp((first - seen.more_lobe) / seen.base_lobe, 0.0F, below_one);
    out.direction = cosine_weighted(normal, {first, point[1]});
  } else {
    return std::nullopt;  // rounding, or a surface that takes all light
  }
  const ScatteredLight light = scattered(seen, normal, to_viewer, out.direction);
  if (!(light.density > 0.0F)) return std::nullopt;
  out.density = light.density;
  out.weight = light.share / light.density;
  out.specular = light.specular / light.density;
  return out;
}

}  // namespace seamline::renderer::glossy
