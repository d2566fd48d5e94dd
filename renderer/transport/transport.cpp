#include "renderer/transport/transport.h"

#include "renderer/light/light_sample.h"
#include "renderer/tracing/surface_point.h"

namespace seamline::renderer {
namespace {

/// Whether a ray that only looks for the sky is left out, because there is no light in it.
bool leaves_out_sky(const Light& light, RayCounts* counts) {
  if (light.skips_sky && counts != nullptr) ++counts->dark_sky_rays;
  return light.skips_sky;
}

/// What a path meets: real things, and the virtual object when it is there.
struct World {
  const Geometry& real;
  const Geometry* object;
  RayCounts* counts;

  [[nodiscard]] bool occluded(const Ray& ray) const {
    return real.occluded(ray, counts) || (object != nullptr && object->occluded(ray, counts));
  }
  [[nodiscard]] bool emits() const { return real.emits() || (object != nullptr && object->emits()); }
  [[nodiscard]] GlowHits glow_hits() const { return real.emits() ? GlowHits::found : GlowHits::unknown; }
  [[nodiscard]] std::optional<SurfacePoint> nearest(Ray ray) const {
    std::optional<SurfacePoint> hit = real.nearest(ray, counts);
    if (object == nullptr) return hit;
    if (hit) ray.far_m = hit->distance_m;
    if (std::optional<SurfacePoint> nearer = object->nearest(ray, counts)) return nearer;
    return hit;
  }
};

/// Radiance scattered by `point`, the path's vertex number `vertex`, and by all later ones.
Rgb scattered(const World& world, SurfacePoint point, const Light& light, const Sampler& sampler,
              int vertex) {
  Rgb sum = Rgb::Zero();
  Rgb throughput = Rgb::Ones();
  for (;; ++vertex) {
    for (int number = 0; number < light_samples(light); ++number) {
      const auto from_light =
          light_sample(light, number, point, throughput, sampler, vertex, world.glow_hits());
      if (from_light && !world.occluded(leaving_ray(point, from_light->direction, from_light->far_m)))
        sum += from_light->radiance;
    }
    const auto next = scatter(point, sampler.point(dimension::direction(vertex)));
    if (!next) return sum;
    throughput *= next->weight;
    const Ray ray = leaving_ray(point, next->direction, light.sky_distance_m);
    if (vertex >= light.bounces && !world.emits() && leaves_out_sky(light, world.counts)) return sum;
    if (vertex >= light.bounces && !world.emits())
      return world.occluded(ray) ? sum : Rgb(sum + throughput * sky_found(light, point, next->direction));
    const std::optional<SurfacePoint> hit = world.nearest(ray);
    if (!hit) return sum + throughput * sky_found(light, point, next->direction);
    sum += throughput * glow_found(light, point, next->direction, *hit).radiance;
    if (vertex >= light.bounces) return sum;
    point = *hit;
  }
}

/// What arrives from a surface that a path hit at the end of vertex `vertex`, without what it glows itself.
Rgb arriving(const World& world, const SurfacePoint& hit, const Light& light, const Sampler& sampler,
             int vertex) {
  if (vertex >= light.bounces) return Rgb::Zero();
  return scattered(world, hit, light, sampler, vertex + 1);
}

/// Adds what a hit glows: what lamps send to the path's first surface is direct, as from any light.
void add_glow(const FoundGlow& glow, const Rgb& throughput, int vertex, Split& light) {
  (glow.is_lamp && vertex == 0 ? light.direct : light.bounce) += throughput * glow.radiance;
}

}  // namespace

RadiancePair leaving_pair(const Geometry& real, const Geometry* object, const SurfacePoint& first,
                          const Light& light, const Sampler& sampler, RayCounts* counts) {
  RadiancePair pair;
  pair.without_object.direct = pair.with_object.direct = first.emission;
  const World world_without{real, nullptr, counts};
  const World world_with{real, object, counts};
  const bool emits = world_with.emits();
  SurfacePoint point = first;
  Rgb throughput = Rgb::Ones();
  for (int vertex = 0;; ++vertex) {
    Rgb& without_object = vertex == 0 ? pair.without_object.direct : pair.without_object.bounce;
    Rgb& with_object = vertex == 0 ? pair.with_object.direct : pair.with_object.bounce;
    for (int number = 0; number < light_samples(light); ++number) {
      const auto from_light =
          light_sample(light, number, point, throughput, sampler, vertex, world_with.glow_hits());
      if (!from_light) continue;
      const Ray ray = leaving_ray(point, from_light->direction, from_light->far_m);
      if (real.occluded(ray, counts)) continue;
      without_object += from_light->radiance;
      if (object == nullptr || !object->occluded(ray, counts)) with_object += from_light->radiance;
    }
    const auto next = scatter(point, sampler.point(dimension::direction(vertex)));
    if (!next) return pair;
    throughput *= next->weight;
    Ray ray = leaving_ray(point, next->direction, light.sky_distance_m);
    const Rgb sky = throughput * sky_found(light, point, next->direction);
    if (vertex >= light.bounces && !emits) {
      if (leaves_out_sky(light, counts) || real.occluded(ray, counts)) return pair;
      without_object += sky;
      if (object == nullptr || !object->occluded(ray, counts)) with_object += sky;
      return pair;
    }
    const std::optional<SurfacePoint> hit = real.nearest(ray, counts);
    if (hit) ray.far_m = hit->distance_m;
    const std::optional<SurfacePoint> object_hit =
        object == nullptr ? std::nullopt : object->nearest(ray, counts);
    if (object_hit) {  // here the two paths part
      if (hit) {
        add_glow(glow_found(light, point, next->direction, *hit), throughput, vertex, pair.without_object);
        pair.without_object.bounce += throughput * arriving(world_without, *hit, light, sampler, vertex);
      } else {
        without_object += sky;
      }
      add_glow(glow_found(light, point, next->direction, *object_hit), throughput, vertex, pair.with_object);
      pair.with_object.bounce += throughput * arriving(world_with, *object_hit, light, sampler, vertex);
      return pair;
    }
    if (!hit) {
      without_object += sky;
      with_object += sky;
      return pair;
    }
    const FoundGlow glow = glow_found(light, point, next->direction, *hit);
    add_glow(glow, throughput, vertex, pair.without_object);
    add_glow(glow, throughput, vertex, pair.with_object);
    if (vertex >= light.bounces) return pair;
    point = *hit;
  }
}

namespace {

bool reaches_past(const RealQuestion& real, const Eigen::Vector3f& direction, float far_m,
                  RayCounts* counts) {
  return above_horizon(*real.start, direction) &&
         !real.geometry->occluded(leaving_ray(*real.start, direction, far_m), counts);
}

/// The real surface that a ray of the object meets; a start below the depth mesh's horizon meets that mesh at
/// once.
std::optional<SurfacePoint> real_hit(const RealQuestion& real, const Eigen::Vector3f& direction, float far_m,
                                     RayCounts* counts) {
  if (!above_horizon(*real.start, direction)) {
    SurfacePoint at_once = *real.start;
    at_once.distance_m = 0.0F;
    return at_once;
  }
  return real.geometry->nearest(leaving_ray(*real.start, direction, far_m), counts);
}

}  // namespace

Split leaving_object(const RealQuestion& lit_past, const RealQuestion& bounced_by, const Geometry& object,
                     const SurfacePoint& point, const Light& light, const Sampler& sampler,
                     RayCounts* counts) {
  Split out;
  out.direct = point.emission;
  const bool bounces_matter =
      bounced_by.geometry != nullptr && (light.bounces > 0 || bounced_by.geometry->emits() || object.emits());
  // Asked of two geometries, lamps are known by their light samples alone.
  const bool same = lit_past.geometry == bounced_by.geometry && lit_past.start == bounced_by.start;
  const bool hits_are_lit = same && bounces_matter && bounced_by.geometry->emits();
  for (int number = 0; number < light_samples(light); ++number) {
    const auto from_light = light_sample(light, number, point, Rgb::Ones(), sampler, 0,
                                         hits_are_lit ? GlowHits::found : GlowHits::unknown);
    if (from_light &&
        !object.occluded(leaving_ray(point, from_light->direction, from_light->far_m), counts) &&
        reaches_past(lit_past, from_light->direction, from_light->far_m, counts))
      out.direct += from_light->radiance;
  }
  const Rgb sky = point.albedo * light.environment_radiance / static_cast<float>(light.sky_rays);
  for (int more = 1; more < light.sky_rays; ++more) {
    const Eigen::Vector3f direction =
        turned_direction(point.normal, sampler.point(dimension::direction(0)), more, light.sky_rays);
    if (above_horizon(point, direction) &&
        !object.occluded(leaving_ray(point, direction, light.sky_distance_m), counts) &&
        reaches_past(lit_past, direction, light.sky_distance_m, counts))
      out.direct += sky;
  }
  const auto next = scatter(point, sampler.point(dimension::direction(0)));
  if (!next) return out;
  const Eigen::Vector3f& direction = next->direction;
  const Rgb found_sky =
      next->weight * sky_found(light, point, direction) / static_cast<float>(light.sky_rays);
  Ray ray = leaving_ray(point, direction, light.sky_distance_m);
  if (!bounces_matter) {
    if (!leaves_out_sky(light, counts) && !object.occluded(ray, counts) &&
        reaches_past(lit_past, direction, light.sky_distance_m, counts))
      out.direct += found_sky;
    return out;
  }
  std::optional<SurfacePoint> hit = real_hit(bounced_by, direction, light.sky_distance_m, counts);
  if (hit) ray.far_m = hit->distance_m;
  // Only the nearer one matters for bounce light, but the sky is hidden by the object at any distance.
  const std::optional<SurfacePoint> object_hit =
      object.nearest(same || !hit ? ray : Ray{ray.origin_m, ray.direction, light.sky_distance_m}, counts);
  const bool object_first = object_hit && (!hit || object_hit->distance_m <= hit->distance_m);
  const bool sky_reaches =
      !object_hit && (same ? !hit : reaches_past(lit_past, direction, light.sky_distance_m, counts));
  if (sky_reaches) out.direct += found_sky;
  if (!object_first && !hit) return out;
  const SurfacePoint& first = object_first ? *object_hit : *hit;
  const FoundGlow glow = glow_found(light, point, direction, first);
  if (!glow.is_lamp || hits_are_lit) add_glow(glow, next->weight, 0, out);
  const World world{*bounced_by.geometry, &object, counts};
  out.bounce += next->weight * arriving(world, first, light, sampler, 0);
  return out;
}

}  // namespace seamline::renderer
