#include "renderer/transport/object_light.h"

#include "raytracer/light/light_sample.h"
#include "raytracer/tracing/surface_point.h"

namespace seamline::renderer {
namespace {

/// Adds the light of the rays that nothing blocks, and begins anew.
void trace(const Geometry& object, const Geometry& real, Coherence coherence, LightRays& rays,
           RayCounts* counts, std::span<Rgb> direct) {
  if (rays.empty()) return;
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
  // Light samples of suns lie together, others do not.
  const auto suns = static_cast<int>(light.suns.size());
  const auto add_samples = [&](int from, int to) {
    for (int number = from; number < to; ++number)
      for (std::size_t i = 0; i < points.size(); ++i)
        if (const auto sample = light_sample(light, number, *points[i].point, Rgb::Ones(), points[i].sampler,
                                             0, EmissionHits::unknown, SunHits::found))
          rays.add(*points[i].point, points[i].lit_past, sample->direction, sample->far_m,
                   {i, sample->radiance});
  };
  add_samples(0, suns);
  trace(object, real, Coherence::together, rays, counts, direct);
  add_samples(suns, light_samples(light));
  trace(object, real, Coherence::scattered, rays, counts, direct);
  if (light.skips_sky) {
    if (counts != nullptr) counts->dark_sky_rays += static_cast<std::int64_t>(points.size());
    return;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& point = *points[i].point;
    const Eigen::Array2f sky_point = points[i].sampler.point(dimension::direction(0));
    const auto share = static_cast<float>(light.sky_rays);
    if (const auto next = scatter(light, point, sky_point))
      rays.add(point, points[i].lit_past, next->direction, light.sky_distance_m,
               {i, next->diffuse() * sky_found(light, point, next->direction) / share +
                       next->weight * suns_found(light, point, next->direction)});
    for (int number = 1; number < light.sky_rays; ++number) {
      const Eigen::Vector3f chosen = turned_direction(point.normal, sky_point, number, light.sky_rays);
      const Eigen::Vector3f direction = leaving_direction(point, chosen);
      if (above_horizon(point, direction))
        rays.add(point, points[i].lit_past, direction, light.sky_distance_m,
                 {i, diffuse_weight(point, chosen) * light.sky(direction) / share});
    }
  }
  trace(object, real, Coherence::scattered, rays, counts, direct);
}

}  // namespace seamline::renderer
