#include "renderer/transport/object_light.h"

#include "renderer/tracing/surface_point.h"

namespace seamline::renderer {
namespace {

/// Adds the light of the rays that nothing blocks, and begins anew.
void trace(const Geometry& object, const Geometry& real, Coherence coherence, LightRays& rays,
           RayCounts* counts, std::span<Rgb> direct) {
  rays.drop_blocked_by_object(object, coherence, counts);
  rays.drop_blocked_by_real(real, coherence, counts);
  for (const LightRays::Arriving& light : rays.arriving()) direct[light.index] += light.radiance;
  rays.clear();
}

}  // namespace

void direct_on_object(std::span<const ObjectPoint> points, const Geometry& object, const Light& light,
                      std::span<Rgb> direct, LightRays& rays, RayCounts* counts) {
  for (std::size_t i = 0; i < points.size(); ++i) direct[i] = points[i].point->emission;
  if (points.empty()) return;
  const Geometry& real = *points.front().lit_past.geometry;
  rays.clear();
  for (const Sun& sun : light.suns)
    for (std::size_t i = 0; i < points.size(); ++i) {
      const SurfacePoint& point = *points[i].point;
      const Eigen::Vector3f to_sun = direction_to_sun(sun, points[i].sampler.point(dimension::sun(0)));
      if (const float cosine = sun_cosine(point, to_sun); cosine > 0.0F)
        rays.add(point, points[i].lit_past, to_sun, endless,
                 {i, point.albedo * sun.irradiance_w_m2 * (inverse_pi * cosine)});
    }
  trace(object, real, Coherence::together, rays, counts, direct);
  if (light.skips_sky) {
    if (counts != nullptr) counts->dark_sky_rays += static_cast<std::int64_t>(points.size());
    return;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& point = *points[i].point;
    const Eigen::Array2f sky_point = points[i].sampler.point(dimension::direction(0));
    const Rgb sky = point.albedo * light.environment_radiance / static_cast<float>(light.sky_rays);
    for (int number = 0; number < light.sky_rays; ++number) {
      const Eigen::Vector3f direction = turned_direction(point.normal, sky_point, number, light.sky_rays);
      if (above_horizon(point, direction))
        rays.add(point, points[i].lit_past, direction, light.sky_distance_m, {i, sky});
    }
  }
  trace(object, real, Coherence::scattered, rays, counts, direct);
}

}  // namespace seamline::renderer
