#include "renderer/transport/uncovered_light.h"

#include <optional>

#include "raytracer/light/light_sample.h"
#include "raytracer/tracing/surface_point.h"

namespace seamline::renderer {
namespace {

/// Adds the light of the rays that the real world lets through, without and with the object, and begins anew.
/// `real`: null where nothing real is asked.
void trace(const Geometry& object, const Geometry* real, Coherence coherence, Rgb Split::*part,
           LightRays& rays, RayCounts* counts, std::span<RadiancePair> pairs) {
  if (rays.empty()) return;
  if (real != nullptr) rays.drop_blocked_by_real(*real, coherence, counts);
  for (const LightRays::Arriving& light : rays.arriving())
    pairs[light.index].without_object.*part += light.radiance;
  rays.drop_blocked_by_object(object, coherence, counts);
  for (const LightRays::Arriving& light : rays.arriving())
    pairs[light.index].with_object.*part += light.radiance;
  rays.clear();
}

/// The receiver, of the truth's material.
SurfacePoint shaded_receiver(const UncoveredPoint& point) {
  SurfacePoint receiver = *point.receiver;
  receiver.albedo = point.shaded_as->albedo;
  receiver.f0 = point.shaded_as->f0;
  receiver.alpha = point.shaded_as->alpha;
  receiver.f90 = point.shaded_as->f90;
  receiver.to_viewer = point.shaded_as->to_viewer;
  return receiver;
}

/// One kind of light on one of many points.
std::optional<LightSample> sample_of(const UncoveredPoint& point, const SurfacePoint& receiver,
                                     const Light& light, int number) {
  return light_sample(light, number, receiver, Rgb::Ones(), point.sampler, 0, EmissionHits::unknown);
}

}  // namespace

void add_suns_by_matte(std::span<const UncoveredPoint> points, const Geometry& object, const Light& light,
                       const ShadowMatte& matte, std::span<RadiancePair> pairs, LightRays& rays,
                       RayCounts* counts) {
  rays.clear();
  for (std::size_t sun = 0; sun < light.suns.size(); ++sun)
    for (std::size_t i = 0; i < points.size(); ++i) {
      const SurfacePoint receiver = shaded_receiver(points[i]);
      const auto sample = sample_of(points[i], receiver, light, static_cast<int>(sun));
      if (!sample) continue;
      const float arrives = arriving_share(matte, sun, {receiver.position_m, points[i].in_photograph});
      if (arrives > 0.0F)
        rays.add(receiver, {nullptr, &receiver}, sample->direction, sample->far_m,
                 {i, arrives * sample->radiance});
    }
  trace(object, nullptr, Coherence::together, &Split::direct, rays, counts, pairs);
}

void direct_on_uncovered(std::span<const UncoveredPoint> points, const Geometry& object, const Light& light,
                         std::span<RadiancePair> pairs, LightRays& rays, RayCounts* counts,
                         const ShadowMatte* matte) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Split emitted{.direct = points[i].shaded_as->emission};
    pairs[i] = {emitted, emitted};
  }
  if (points.empty()) return;
  const Geometry& real = *points.front().lit.geometry;
  rays.clear();
  const auto suns = static_cast<int>(light.suns.size());  // whose rays lie together
  const auto add_samples = [&](int from, int to) {
    for (int number = from; number < to; ++number)
      for (std::size_t i = 0; i < points.size(); ++i) {
        const SurfacePoint receiver = shaded_receiver(points[i]);
        if (const auto sample = sample_of(points[i], receiver, light, number))
          rays.add(receiver, points[i].lit, sample->direction, sample->far_m, {i, sample->radiance});
      }
  };
  if (matte != nullptr) {
    add_suns_by_matte(points, object, light, *matte, pairs, rays, counts);
  } else {
    add_samples(0, suns);
    trace(object, &real, Coherence::together, &Split::direct, rays, counts, pairs);
  }
  add_samples(suns, light_samples(light));
  trace(object, &real, Coherence::scattered, &Split::direct, rays, counts, pairs);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint receiver = shaded_receiver(points[i]);
    const auto next = scatter(light, receiver, points[i].sampler.point(dimension::direction(0)));
    if (!next) continue;
    if (!light.skips_sky)
      rays.add(receiver, points[i].lit, next->direction, light.sky_distance_m,
               {i, next->diffuse() * sky_found(light, receiver, next->direction)});
    else if (counts != nullptr)
      ++counts->dark_sky_rays;
  }
  // A map's light has edges, which no filter of bounce light may touch.
  Rgb Split::*const part = light.environment ? &Split::direct : &Split::bounce;
  trace(object, &real, Coherence::scattered, part, rays, counts, pairs);
}

}  // namespace seamline::renderer
