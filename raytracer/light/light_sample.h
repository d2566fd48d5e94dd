#pragma once
#include <algorithm>
#include <optional>

#include "raytracer/common/sampler.h"
#include "raytracer/light/light.h"
#include "raytracer/tracing/surface_point.h"

namespace seamline::renderer {

/// How a surface sends on what reaches it: one place for what all estimators know of it.
struct Scattered {
  Eigen::Vector3f direction;   ///< unit, where the path goes on
  Rgb weight;                  ///< scattered share times cosine, over the density
  Rgb specular = Rgb::Zero();  ///< what of the weight is the specular layer's
  float spread = 1.0F;         ///< how far the lobe that it was taken from spreads: its alpha, or 1

  [[nodiscard]] Rgb diffuse() const { return weight - specular; }
  /// What of light that comes that way is mirrored, 0 to 1.
  [[nodiscard]] Rgb mirrored_share() const { return (weight > 0.0F).select(specular / weight, 0.0F); }
};
/// The direction in which a path leaves a point, for a point of [0, 1)^2; none below the surface's horizon.
/// As the surface scatters; where the spots of lamps are worth it, some paths go towards one of those.
[[nodiscard]] std::optional<Scattered> scatter(const Light& light, const SurfacePoint& from,
                                               const Eigen::Array2f& point);

/// A glossy surface as a path meets it that a spread lobe led there: no smoother than alpha 0.25 (roughness
/// 0.5), nor than that lobe. What a mirror casts onto a rough surface (a caustic) is a light that sampling
/// hardly ever finds, and then as one bright speck; so it is blurred, in both estimators, and keeps its
/// energy (Kaplanyan and Dachsbacher, "Path Space Regularization", CGF 32(2), 2013). What is seen directly or
/// in a chain of mirrors is as smooth as it is.
inline void blur_after(float spread, SurfacePoint& met) {
  if ((met.f0 > 0.0F).any()) met.alpha = std::max(met.alpha, std::min(spread, 0.25F));
}

/// Per steradian, with which `scatter` chooses a direction.
[[nodiscard]] float scatter_density_sr(const Light& light, const SurfacePoint& from,
                                       const Eigen::Vector3f& direction);

/// The weight of the diffuse base alone for a cosine-weighted direction, before `leaving_direction` moves it:
/// its share times cosine, over the cosine's density.
[[nodiscard]] Rgb diffuse_weight(const SurfacePoint& from, const Eigen::Vector3f& direction);

/// BSDF times cosine for light from a direction, over all of what `scatter` sends there; zero below the
/// surface.
[[nodiscard]] Rgb scattered_share_above(const SurfacePoint& point, const Eigen::Vector3f& direction);

/// Light that reaches a point from one direction if nothing is in the way.
struct LightSample {
  Eigen::Vector3f direction;  ///< unit, towards the light
  float far_m;                ///< where the ray that asks ends, before the lamp
  Rgb radiance;               ///< that goes on to the viewer: times the throughput, over the density
  /// The same off the specular layer, of light that paths find as well: it counts as mirrored.
  Rgb mirrored = Rgb::Zero();
  bool of_photograph = false;  ///< from a surface of `Light::photographed`

  [[nodiscard]] Rgb total() const { return radiance + mirrored; }
};

/// Whether a surface of the background emits.
[[nodiscard]] inline bool has_emitters(const Light& light) {
  return light.emitters != nullptr && !light.emitters->empty();
}

/// Questions that every surface asks of its light: one of each sun, one of all lamps without size, one of the
/// emitting surfaces, one of the environment's map. A scene that has none of a kind asks none of it.
[[nodiscard]] inline int light_samples(const Light& light) {
  return static_cast<int>(light.suns.size()) + (light.lamps.empty() ? 0 : 1) + (has_emitters(light) ? 1 : 0) +
         (light.environment ? 1 : 0);
}

/// Whether the rays on which paths go on find the surfaces that emit: in the truth, and not in the depth
/// mesh, which knows nothing of them.
enum class EmissionHits { found, unknown };

/// Whether they find the discs of suns with size, where they leave a mirror: seen in one whose lobe is
/// narrower, a sun would be a few samples that are as much brighter than its disc.
enum class SunHits { found, unknown };
/// At a point where `SunHits::found` says so. Nobody looks for them where no path looks for a dark sky, nor
/// where all are hard.
[[nodiscard]] inline bool finds_suns(const Light& light, const SurfacePoint& from) {
  return !light.skips_sky && (from.f0 > 0.0F).any() &&
         std::any_of(light.suns.begin(), light.suns.end(),
                     [](const Sun& sun) { return sun.angular_radius_rad > 0.0F; });
}

/// Question `number` of those. `throughput`: from the point to the camera, without the point's own albedo.
/// Light that the paths that go on may find as well (the environment's map always, emitting surfaces with
/// `EmissionHits::found`, suns with `SunHits::found`) is weighted by the power heuristic (Veach and Guibas,
/// SIGGRAPH 1995). None when no light comes from there.
[[nodiscard]] std::optional<LightSample> light_sample(const Light& light, int number,
                                                      const SurfacePoint& point, const Rgb& throughput,
                                                      const Sampler& sampler, int vertex, EmissionHits hits,
                                                      SunHits sun_hits = SunHits::unknown);

/// The environment as found by a path that left `from` in a direction of `scatter`: its radiance, less what
/// `light_sample` counts of it.
[[nodiscard]] inline Rgb sky_found(const Light& light, const SurfacePoint& from,
                                   const Eigen::Vector3f& direction);

/// Suns with size as such a path found them, less what `light_sample` counts of them with `SunHits::found`.
[[nodiscard]] inline Rgb suns_found(const Light& light, const SurfacePoint& from,
                                    const Eigen::Vector3f& direction);

/// Whether a surface is one of those that send what a photograph shows (`Light::photographed`): paths end
/// there.
[[nodiscard]] inline bool sends_photograph(const Light& light, const SurfacePoint& hit) {
  return light.photographed != nullptr && hit.object_index == 0;
}

/// What a surface that such a path met emits, less what `light_sample` counts of it. `is_lamp`: whether it is
/// one of those that `light_sample` knows.
struct FoundEmission {
  Rgb radiance;
  bool is_lamp;
};
[[nodiscard]] FoundEmission emission_found(const Light& light, const SurfacePoint& from,
                                           const Eigen::Vector3f& direction, const SurfacePoint& hit);

[[nodiscard]] Rgb mapped_sky_found(const Light& light, const SurfacePoint& from,
                                   const Eigen::Vector3f& direction);

[[nodiscard]] Rgb mirrored_suns_found(const Light& light, const SurfacePoint& from,
                                      const Eigen::Vector3f& direction);

inline Rgb sky_found(const Light& light, const SurfacePoint& from, const Eigen::Vector3f& direction) {
  // No light sample looks for what a surface hides.
  if (const Rgb* hidden = light.hidden_sky_in(direction)) return *hidden;
  return light.environment ? mapped_sky_found(light, from, direction) : light.environment_radiance;
}

inline Rgb suns_found(const Light& light, const SurfacePoint& from, const Eigen::Vector3f& direction) {
  return finds_suns(light, from) ? mirrored_suns_found(light, from, direction) : Rgb::Zero();
}

}  // namespace seamline::renderer
