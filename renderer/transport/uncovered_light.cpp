#include "renderer/transport/uncovered_light.h"

#include "renderer/tracing/surface_point.h"

namespace seamline::renderer {
namespace {

/// Adds the light of the rays that the real world lets through, without and with the object, and begins anew.
void trace(const Geometry& object, const Geometry& real, Coherence coherence, Rgb Split::*part,
           LightRays& rays, RayCounts* counts, std::span<RadiancePair> pairs) {
  rays.drop_blocked_by_real(real, coherence, counts);
  for (const LightRays::Arriving& light : rays.arriving())
    pairs[light.index].without_object.*part += light.radiance;
  rays.drop_blocked_by_object(object, coherence, counts);
  for (const LightRays::Arriving& light : rays.arriving())
    pairs[light.index].with_object.*part += light.radiance;
  rays.clear();
}

}  // namespace

void direct_on_uncovered(std::span<const UncoveredPoint> points, const Geometry& object, const Light& light,
                         std::span<RadiancePair> pairs, LightRays& rays, RayCounts* counts) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Split emitted{.direct = points[i].emission};
    pairs[i] = {emitted, emitted};
  }
  if (points.empty()) return;
  const Geometry& real = *points.front().lit.geometry;
  rays.clear();
  for (const Sun& sun : light.suns)
    for (std::size_t i = 0; i < points.size(); ++i) {
      const SurfacePoint& receiver = *points[i].receiver;
      const Eigen::Vector3f to_sun = direction_to_sun(sun, points[i].sampler.point(dimension::sun(0)));
      if (const float cosine = sun_cosine(receiver, to_sun); cosine > 0.0F)
        rays.add(receiver, points[i].lit, to_sun, endless,
                 {i, points[i].albedo * sun.irradiance_w_m2 * (inverse_pi * cosine)});
    }
  trace(object, real, Coherence::together, &Split::direct, rays, counts, pairs);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& receiver = *points[i].receiver;
    const Eigen::Vector3f direction =
        cosine_direction(receiver.normal, points[i].sampler.point(dimension::direction(0)));
    if (!above_horizon(receiver, direction)) continue;
    if (!light.skips_sky)
      rays.add(receiver, points[i].lit, direction, light.sky_distance_m,
               {i, points[i].albedo * light.environment_radiance});
    else if (counts != nullptr)
      ++counts->dark_sky_rays;
  }
  trace(object, real, Coherence::scattered, &Split::bounce, rays, counts, pairs);
}

}  // namespace seamline::renderer
