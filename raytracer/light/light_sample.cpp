#include "raytracer/light/light_sample.h"

#include <algorithm>
#include <cmath>

#include "raytracer/light/bright_patches.h"
#include "raytracer/tracing/geometry.h"

namespace seamline::renderer {
namespace {

/// Rays to a lamp end before it by this share of their way.
constexpr float before_lamp = 1.0F - 1e-4F;

/// The power heuristic's weight of a density beside another.
float power_weight(float own, float other) {
  if (!(own > 0.0F)) return 0.0F;
  const float ratio = other / own;
  return 1.0F / (1.0F + ratio * ratio);
}

/// What a glossy point does with light of a direction above its triangle: that of the direction itself, and
/// of the one below which `leaving_direction` mirrors there.
ScatteredLight scattered_above(const SurfacePoint& point, const Eigen::Vector3f& direction) {
  const Scatterer surface = scatterer(point);
  ScatteredLight light = scattered_light(surface, point.normal, point.to_viewer, direction);
  const Eigen::Vector3f below =
      direction - 2.0F * point.geometric_normal.dot(direction) * point.geometric_normal;
  if (!(point.normal.dot(below) > 0.0F)) return light;
  const ScatteredLight mirrored = scattered_light(surface, point.normal, point.to_viewer, below);
  light.share += mirrored.share;
  light.specular += mirrored.specular;
  light.density += mirrored.density;
  return light;
}

/// What paths that a surface scatters have of a direction above its triangle.
ScatteredLight scattered_by_surface(const SurfacePoint& from, const Eigen::Vector3f& direction) {
  if ((from.f0 > 0.0F).any()) return scattered_above(from, direction);
  return scattered_light(scatterer(from), from.normal, from.to_viewer, direction);
}

/// Light from a direction, sent on.
struct SentOn {
  Rgb diffuse, specular;
};
/// What a point sends on of light per steradian over a density, or of irradiance, from a direction. None
/// below the horizon.
std::optional<SentOn> sent_on(const SurfacePoint& point, const Rgb& throughput, const Rgb& light,
                              const Eigen::Vector3f& direction) {
  if (!(point.f0 > 0.0F).any()) {
    const float cosine = sun_cosine(point, direction);
    if (cosine <= 0.0F) return std::nullopt;
    return SentOn{throughput * point.albedo * light * (inverse_pi * cosine), Rgb::Zero()};
  }
  if (!above_horizon(point, direction)) return std::nullopt;
  const ScatteredLight scattered = scattered_above(point, direction);
  if (!(scattered.density > 0.0F)) return std::nullopt;
  const Rgb arriving = throughput * light;
  return SentOn{arriving * (scattered.share - scattered.specular), arriving * scattered.specular};
}

/// Suns and lamps without size have highlights; paths never find them.
LightSample highlighted(const Eigen::Vector3f& direction, float far_m, const SentOn& sent) {
  return {direction, far_m, sent.diffuse + sent.specular, Rgb::Zero()};
}

bool is_finite(const SentOn& sent) {
  return sent.diffuse.allFinite() && sent.specular.allFinite();
}

std::optional<LightSample> sun_sample(const Light& light, const Sun& sun, const SurfacePoint& point,
                                      const Rgb& throughput, const Sampler& sampler, int vertex,
                                      SunHits hits) {
  const Eigen::Array2f on_disc =
      sun.angular_radius_rad > 0.0F ? sampler.point(dimension::sun(vertex)) : Eigen::Array2f::Zero();
  const Eigen::Vector3f to_sun = direction_to_sun(sun, on_disc);
  const bool is_found = hits == SunHits::found && sun.angular_radius_rad > 0.0F && finds_suns(light, point);
  const float weight =
      is_found ? power_weight(disc_density_sr(sun), scatter_density_sr(light, point, to_sun)) : 1.0F;
  const auto sent = sent_on(point, throughput, weight * sun.irradiance_w_m2, to_sun);
  if (!sent) return std::nullopt;
  return highlighted(to_sun, endless, *sent);
}

std::optional<LightSample> lamp_sample(const Light& light, const SurfacePoint& point, const Rgb& throughput,
                                       const Sampler& sampler, int vertex) {
  const auto chosen = choose_lamp(light.lamps, point, sampler.point(dimension::lamp(vertex))[0]);
  if (!chosen) return std::nullopt;
  const Eigen::Vector3f to_lamp = chosen->lamp->position_m - point.position_m;
  const float distance_m = to_lamp.norm();
  if (!(distance_m > 0.0F)) return std::nullopt;
  const Eigen::Vector3f direction = to_lamp / distance_m;
  const Rgb irradiance =
      intensity_towards(*chosen->lamp, -direction) / (distance_m * distance_m * chosen->probability);
  const auto sent = sent_on(point, throughput, irradiance, direction);
  if (!sent || !is_finite(*sent)) return std::nullopt;
  return highlighted(direction, distance_m * before_lamp, *sent);
}

std::optional<LightSample> emission_sample(const Light& light, const SurfacePoint& point,
                                           const Rgb& throughput, const Sampler& sampler, int vertex,
                                           EmissionHits hits) {
  const EmittingSurfaces::Place place = light.emitters->sample(
      sampler.point(dimension::emission_choice(vertex))[0], sampler.point(dimension::emission(vertex)));
  const Eigen::Vector3f to_place = place.position_m - point.position_m;
  const float distance_m = to_place.norm();
  if (!(distance_m > 0.0F)) return std::nullopt;
  const Eigen::Vector3f direction = to_place / distance_m;
  const float facing = std::abs(place.normal.dot(direction));
  if (!(facing > 0.0F)) return std::nullopt;
  const float density_sr = place.density_m2 * distance_m * distance_m / facing;
  if (!(density_sr > 0.0F)) return std::nullopt;
  const float weight = hits == EmissionHits::found
                           ? power_weight(density_sr, scatter_density_sr(light, point, direction))
                           : 1.0F;
  const auto sent = sent_on(point, throughput, place.radiance * (weight / density_sr), direction);
  if (!sent || !is_finite(*sent)) return std::nullopt;
  return LightSample{direction, distance_m * before_lamp, sent->diffuse, sent->specular};
}

/// The density, per steradian at a point, with which a place of the photographed surfaces is chosen by a
/// direction from the origin of density `chosen_sr`.
float density_of_place(const SurfacePoint& place, const Eigen::Vector3f& from_origin, float chosen_sr,
                       const Eigen::Vector3f& from_point, float distance_m) {
  const float facing = std::max(1e-12F, std::abs(place.geometric_normal.dot(from_point)));
  const float seen = std::abs(place.geometric_normal.dot(from_origin));
  const float ratio = distance_m / place.position_m.norm();
  return chosen_sr * ratio * ratio * seen / facing;
}

/// The panorama's light that a direction from the origin shows, when it comes from a surface.
std::optional<LightSample> photographed_sample(const Light& light, const SurfacePoint& place,
                                               const EnvironmentMap::Direction& chosen,
                                               const SurfacePoint& point, const Rgb& throughput) {
  const Eigen::Vector3f to_place = place.position_m - point.position_m;
  const float distance_m = to_place.norm();
  if (!(distance_m > 0.0F)) return std::nullopt;
  const Eigen::Vector3f direction = to_place / distance_m;
  const float density_sr =
      density_of_place(place, chosen.direction, chosen.density_sr, direction, distance_m);
  if (!(density_sr > 0.0F)) return std::nullopt;
  const float weight = power_weight(density_sr, scatter_density_sr(light, point, direction));
  const auto sent = sent_on(point, throughput,
                            light.environment->radiance(chosen.direction) * (weight / density_sr), direction);
  if (!sent || !is_finite(*sent)) return std::nullopt;
  return LightSample{direction, distance_m * before_lamp, sent->diffuse, sent->specular, true};
}

std::optional<LightSample> map_sample(const Light& light, const SurfacePoint& point, const Rgb& throughput,
                                      const Sampler& sampler, int vertex) {
  const EnvironmentMap& map = *light.environment;
  const EnvironmentMap::Direction chosen = map.sample(sampler.point(dimension::environment(vertex)));
  const auto& [direction, density_sr] = chosen;
  if (!(density_sr > 0.0F)) return std::nullopt;
  if (light.photographed)
    if (const auto place = light.photographed->nearest({Eigen::Vector3f::Zero(), direction}))
      return photographed_sample(light, *place, chosen, point, throughput);
  const float weight = power_weight(density_sr, scatter_density_sr(light, point, direction));
  const auto sent = sent_on(point, throughput, map.radiance(direction) * (weight / density_sr), direction);
  if (!sent) return std::nullopt;
  return LightSample{direction, light.sky_distance_m, sent->diffuse, sent->specular};
}

}  // namespace

namespace {

std::optional<Scattered> scatter_by_surface(const SurfacePoint& from, const Eigen::Array2f& point) {
  const auto next = sample_scattering(scatterer(from), from.normal, from.to_viewer, point);
  if (!next) return std::nullopt;
  const Eigen::Vector3f direction = leaving_direction(from, next->direction);
  if (!above_horizon(from, direction)) return std::nullopt;
  return Scattered{direction, next->weight, next->specular, next->specular_lobe ? from.alpha : 1.0F};
}

/// A direction of the surface or towards a spot, over the density of both together (one-sample balance
/// heuristic: Veach and Guibas, SIGGRAPH 1995).
std::optional<Scattered> scatter_with(const BrightPatches& bright, const PatchAim& aim,
                                      const SurfacePoint& from, const Eigen::Array2f& point) {
  Eigen::Vector3f direction;
  if (point[0] < aim.sum) {
    direction = direction_to_patch(bright, aim, from, {point[0] / aim.sum, point[1]});
  } else {
    const auto next = scatter_by_surface(from, {(point[0] - aim.sum) / (1.0F - aim.sum), point[1]});
    if (!next) return std::nullopt;
    direction = next->direction;
  }
  if (!above_horizon(from, direction)) return std::nullopt;
  const ScatteredLight light = scattered_by_surface(from, direction);
  const float density_sr = (1.0F - aim.sum) * light.density + patch_density_sr(bright, aim, from, direction);
  if (!(density_sr > 0.0F)) return std::nullopt;
  return Scattered{direction, light.share / density_sr, light.specular / density_sr};
}

}  // namespace

std::optional<Scattered> scatter(const Light& light, const SurfacePoint& from, const Eigen::Array2f& point) {
  if (const BrightPatches* patches = light.emitters ? light.emitters->patches() : nullptr)
    if (const PatchAim aim = aim_at_patches(*patches, from); aim.sum > 0.0F)
      return scatter_with(*patches, aim, from, point);
  return scatter_by_surface(from, point);
}

float scatter_density_sr(const Light& light, const SurfacePoint& from, const Eigen::Vector3f& direction) {
  if (const BrightPatches* patches = light.emitters ? light.emitters->patches() : nullptr)
    if (const PatchAim aim = aim_at_patches(*patches, from); aim.sum > 0.0F)
      return (1.0F - aim.sum) * scattered_by_surface(from, direction).density +
             patch_density_sr(*patches, aim, from, direction);
  return scattered_by_surface(from, direction).density;
}

Rgb scattered_share_above(const SurfacePoint& point, const Eigen::Vector3f& direction) {
  if ((point.f0 > 0.0F).any())
    return above_horizon(point, direction) ? scattered_above(point, direction).share : Rgb(Rgb::Zero());
  return point.albedo * (inverse_pi * sun_cosine(point, direction));
}

Rgb diffuse_weight(const SurfacePoint& from, const Eigen::Vector3f& direction) {
  const Scatterer surface = scatterer(from);
  if (!is_glossy(surface)) return surface.albedo;
  const float density_sr = inverse_pi * from.normal.dot(direction);
  if (!(density_sr > 0.0F)) return Rgb::Zero();
  const ScatteredLight scattered = scattered_light(surface, from.normal, from.to_viewer, direction);
  return (scattered.share - scattered.specular) / density_sr;
}

std::optional<LightSample> light_sample(const Light& light, int number, const SurfacePoint& point,
                                        const Rgb& throughput, const Sampler& sampler, int vertex,
                                        EmissionHits hits, SunHits sun_hits) {
  const auto suns = static_cast<int>(light.suns.size());
  if (number < suns)
    return sun_sample(light, light.suns[number], point, throughput, sampler, vertex, sun_hits);
  number -= suns;
  if (!light.lamps.empty() && number-- == 0) return lamp_sample(light, point, throughput, sampler, vertex);
  if (has_emitters(light) && number-- == 0)
    return emission_sample(light, point, throughput, sampler, vertex, hits);
  return map_sample(light, point, throughput, sampler, vertex);
}

Rgb mapped_sky_found(const Light& light, const SurfacePoint& from, const Eigen::Vector3f& direction) {
  const EnvironmentMap& map = *light.environment;
  return map.radiance(direction) *
         power_weight(scatter_density_sr(light, from, direction), map.density_sr(direction));
}

Rgb mirrored_suns_found(const Light& light, const SurfacePoint& from, const Eigen::Vector3f& direction) {
  Rgb sum = Rgb::Zero();
  for (const Sun& sun : light.suns)
    if (const Rgb radiance = disc_radiance(sun, direction); (radiance > 0.0F).any())
      sum += radiance * power_weight(scatter_density_sr(light, from, direction), disc_density_sr(sun));
  return sum;
}

FoundEmission emission_found(const Light& light, const SurfacePoint& from, const Eigen::Vector3f& direction,
                             const SurfacePoint& hit) {
  if (sends_photograph(light, hit)) {
    const Eigen::Vector3f from_origin = hit.position_m.normalized();
    const float chosen_sr = density_of_place(hit, from_origin, light.environment->density_sr(from_origin),
                                             direction, hit.distance_m);
    return {light.environment->radiance(from_origin) *
                power_weight(scatter_density_sr(light, from, direction), chosen_sr),
            true};
  }
  const float density_m2 = has_emitters(light) ? light.emitters->density_m2(hit) : 0.0F;
  if (!(density_m2 > 0.0F)) return {hit.emission, false};
  const float facing = std::max(1e-12F, std::abs(hit.geometric_normal.dot(direction)));
  const float density_sr = density_m2 * hit.distance_m * hit.distance_m / facing;
  return {hit.emission * power_weight(scatter_density_sr(light, from, direction), density_sr), true};
}

}  // namespace seamline::renderer
