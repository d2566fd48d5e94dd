#include "renderer/transport/transport.h"

#include "raytracer/light/light_sample.h"
#include "raytracer/tracing/surface_point.h"

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
  [[nodiscard]] EmissionHits emission_hits() const {
    return real.emits() ? EmissionHits::found : EmissionHits::unknown;
  }
  [[nodiscard]] std::optional<SurfacePoint> nearest(Ray ray) const {
    std::optional<SurfacePoint> hit = real.nearest(ray, counts);
    if (object == nullptr) return hit;
    if (hit) ray.far_m = hit->distance_m;
    if (std::optional<SurfacePoint> nearer = object->nearest(ray, counts)) return nearer;
    return hit;
  }
};

/// What a path finds that meets nothing.
Rgb far_light(const Light& light, const SurfacePoint& from, const Eigen::Vector3f& direction) {
  return sky_found(light, from, direction) + suns_found(light, from, direction);
}

Rgb change_of_sent(const World& world, const SurfacePoint& from, const Light& light, const Sampler& sampler,
                   int vertex);

/// Radiance scattered by `point`, the path's vertex number `vertex`, and by all later ones.
Rgb scattered(const World& world, SurfacePoint point, const Light& light, const Sampler& sampler,
              int vertex) {
  Rgb sum = Rgb::Zero();
  Rgb throughput = Rgb::Ones();
  for (;; ++vertex) {
    for (int number = 0; number < light_samples(light); ++number) {
      const auto from_light = light_sample(light, number, point, throughput, sampler, vertex,
                                           world.emission_hits(), SunHits::found);
      if (from_light && !world.occluded(leaving_ray(point, from_light->direction, from_light->far_m)))
        sum += from_light->total();
    }
    const auto next = scatter(light, point, sampler.point(dimension::direction(vertex)));
    if (!next) return sum;
    throughput *= next->weight;
    const Ray ray = leaving_ray(point, next->direction, light.sky_distance_m);
    const bool emits = world.emits() || light.photographed != nullptr;
    if (vertex >= light.bounces && !emits && leaves_out_sky(light, world.counts)) return sum;
    if (vertex >= light.bounces && !emits)
      return world.occluded(ray) ? sum : Rgb(sum + throughput * far_light(light, point, next->direction));
    const std::optional<SurfacePoint> hit = world.nearest(ray);
    if (!hit) return sum + throughput * far_light(light, point, next->direction);
    sum += throughput * emission_found(light, point, next->direction, *hit).radiance;
    if (vertex >= light.bounces) return sum;
    if (sends_photograph(light, *hit))
      return sum + throughput * change_of_sent(world, *hit, light, sampler, vertex);
    point = *hit;
    blur_after(next->spread, point);
  }
}

/// What arrives from a surface that a path hit at the end of vertex `vertex`, without what it emits itself.
Rgb arriving(const World& world, SurfacePoint hit, float spread, const Light& light, const Sampler& sampler,
             int vertex) {
  if (vertex >= light.bounces) return Rgb::Zero();
  if (sends_photograph(light, hit)) return change_of_sent(world, hit, light, sampler, vertex);
  blur_after(spread, hit);
  return scattered(world, hit, light, sampler, vertex + 1);
}

/// What the object changes of the radiance that a photographed surface sends, which a path met at the end of
/// vertex `vertex`. The photograph is what it sends without the object; with it, that follows what it
/// receives: less what the object keeps away, more by what the object sends, times the albedo that the
/// photograph implies (`paint_sent_light`). One sample.
Rgb change_of_sent(const World& world, const SurfacePoint& from, const Light& light, const Sampler& sampler,
                   int vertex) {
  if (world.object == nullptr || vertex >= light.bounces) return Rgb::Zero();
  ++vertex;
  Rgb change = Rgb::Zero();
  for (int number = 0; number < light_samples(light); ++number) {
    const auto sample = light_sample(light, number, from, Rgb::Ones(), sampler, vertex, world.emission_hits(),
                                     SunHits::found);
    if (!sample) continue;
    const Ray ray = leaving_ray(from, sample->direction, sample->far_m);
    if (world.object->occluded(ray, world.counts) && !world.real.occluded(ray, world.counts))
      change -= sample->total();
  }
  const auto next = scatter(light, from, sampler.point(dimension::direction(vertex)));
  if (!next) return change;
  const Ray ray = leaving_ray(from, next->direction, light.sky_distance_m);
  const std::optional<SurfacePoint> met = world.object->nearest(ray, world.counts);
  if (!met) return change;
  const std::optional<SurfacePoint> behind = world.real.nearest(ray, world.counts);
  if (behind && behind->distance_m <= met->distance_m) return change;
  const Rgb kept_away = behind ? emission_found(light, from, next->direction, *behind).radiance
                               : far_light(light, from, next->direction);
  const Rgb sent = emission_found(light, from, next->direction, *met).radiance +
                   arriving(world, *met, next->spread, light, sampler, vertex);
  return change + next->weight * (sent - kept_away);
}

/// What a path finds, sorted by how it left its first surface.
class FoundLight {
 public:
  explicit FoundLight(Split& light) : light_(light) {}

  void leaves_first_by(const Scattered& next) {
    mirrors_ = (next.specular > 0.0F).any();
    if (mirrors_) share_ = next.mirrored_share();
  }
  /// Light that the path found, its throughput in it. What lamps and the environment send straight to the
  /// first surface is direct.
  void add(const Rgb& light, bool direct) {
    Rgb& rest = direct ? light_.direct : light_.bounce;
    if (!mirrors_) {
      rest += light;
      return;
    }
    light_.mirrored += share_ * light;
    rest += (1.0F - share_) * light;
  }
  /// Environment and suns behind everything; a sun in the first surface is a highlight, which is direct.
  void add_far(const Rgb& sky, const Rgb& suns, bool is_first) {
    add(sky, is_first);
    if (is_first)
      light_.direct += suns;
    else
      add(suns, false);
  }
  void add(const LightSample& sample, int vertex) {
    if (vertex > 0) {
      add(sample.total(), false);
      return;
    }
    light_.direct += sample.radiance;
    light_.mirrored += sample.mirrored;
  }

 private:
  Split& light_;
  bool mirrors_ = false;
  Rgb share_ = Rgb::Zero();
};

}  // namespace

RadiancePair radiance_with_and_without(const Geometry& real, const Geometry* object,
                                       const SurfacePoint& first, const Light& light, const Sampler& sampler,
                                       RayCounts* counts) {
  RadiancePair pair;
  pair.without_object.direct = pair.with_object.direct = first.emission;
  const World world_without{real, nullptr, counts};
  const World world_with{real, object, counts};
  const bool emits = world_with.emits() || light.photographed != nullptr;
  FoundLight without_object(pair.without_object), with_object(pair.with_object);
  SurfacePoint point = first;
  Rgb throughput = Rgb::Ones();
  for (int vertex = 0;; ++vertex) {
    for (int number = 0; number < light_samples(light); ++number) {
      const auto from_light = light_sample(light, number, point, throughput, sampler, vertex,
                                           world_with.emission_hits(), SunHits::found);
      if (!from_light) continue;
      const Ray ray = leaving_ray(point, from_light->direction, from_light->far_m);
      if (real.occluded(ray, counts)) continue;
      without_object.add(*from_light, vertex);
      if (object == nullptr || !object->occluded(ray, counts)) with_object.add(*from_light, vertex);
    }
    const auto next = scatter(light, point, sampler.point(dimension::direction(vertex)));
    if (!next) return pair;
    throughput *= next->weight;
    if (vertex == 0) without_object.leaves_first_by(*next), with_object.leaves_first_by(*next);
    Ray ray = leaving_ray(point, next->direction, light.sky_distance_m);
    const Rgb sky = throughput * sky_found(light, point, next->direction);
    const Rgb suns = throughput * suns_found(light, point, next->direction);
    const bool is_first = vertex == 0;
    if (vertex >= light.bounces && !emits) {
      if (leaves_out_sky(light, counts) || real.occluded(ray, counts)) return pair;
      without_object.add_far(sky, suns, is_first);
      if (object == nullptr || !object->occluded(ray, counts)) with_object.add_far(sky, suns, is_first);
      return pair;
    }
    const std::optional<SurfacePoint> hit = real.nearest(ray, counts);
    if (hit) ray.far_m = hit->distance_m;
    const std::optional<SurfacePoint> object_hit =
        object == nullptr ? std::nullopt : object->nearest(ray, counts);
    const auto add_emission = [&](const SurfacePoint& emitter, FoundLight& found) {
      const FoundEmission emission = emission_found(light, point, next->direction, emitter);
      found.add(throughput * emission.radiance, emission.is_lamp && is_first);
    };
    if (object_hit) {  // here the two paths part
      if (hit) {
        add_emission(*hit, without_object);
        without_object.add(throughput * arriving(world_without, *hit, next->spread, light, sampler, vertex),
                           false);
      } else {
        without_object.add_far(sky, suns, is_first);
      }
      add_emission(*object_hit, with_object);
      with_object.add(throughput * arriving(world_with, *object_hit, next->spread, light, sampler, vertex),
                      false);
      return pair;
    }
    if (!hit) {
      without_object.add_far(sky, suns, is_first);
      with_object.add_far(sky, suns, is_first);
      return pair;
    }
    add_emission(*hit, without_object);
    add_emission(*hit, with_object);
    if (vertex >= light.bounces) return pair;
    if (sends_photograph(light, *hit)) {
      with_object.add(throughput * change_of_sent(world_with, *hit, light, sampler, vertex), false);
      return pair;
    }
    point = *hit;
    blur_after(next->spread, point);
  }
}

Rgb change_of_sent(const Geometry& real, const Geometry& object, const SurfacePoint& from, const Light& light,
                   const Sampler& sampler, int vertex, RayCounts* counts) {
  return change_of_sent({real, &object, counts}, from, light, sampler, vertex);
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

bool same(const RealQuestion& a, const RealQuestion& b) {
  return a.geometry == b.geometry && a.start == b.start;
}

/// Light of a virtual object's point, past real things.
class ObjectLight {
 public:
  ObjectLight(const Geometry& object, const SurfacePoint& point, const Light& light, const Sampler& sampler,
              RayCounts* counts)
      : object_(object), point_(point), light_(light), sampler_(sampler), counts_(counts) {}

  /// Whether anything but the sky can be found where `by` is asked.
  [[nodiscard]] bool bounces_matter(const RealQuestion& by) const {
    return by.geometry != nullptr && (light_.bounces > 0 || emits(by) || object_.emits());
  }
  /// Whether paths that are asked so find lamps with size. Asked of two geometries, these are known by their
  /// light samples alone.
  [[nodiscard]] EmissionHits emission_hits(const RealQuestion& lit_past, const RealQuestion& by) const {
    return same(lit_past, by) && bounces_matter(by) && emits(by) ? EmissionHits::found
                                                                 : EmissionHits::unknown;
  }

  /// Calls `take` with every light sample that reaches the point past the object and past the real world.
  template <class Take>
  void each_sample(const RealQuestion& lit_past, EmissionHits hits, const Take& take) const {
    for (int number = 0; number < light_samples(light_); ++number) {
      const auto sample =
          light_sample(light_, number, point_, Rgb::Ones(), sampler_, 0, hits, SunHits::found);
      if (sample && !(sample->of_photograph && only_paths_find_photograph(lit_past)) &&
          !object_.occluded(leaving_ray(point_, sample->direction, sample->far_m), counts_) &&
          reaches_past(lit_past, sample->direction, sample->far_m, counts_))
        take(*sample);
    }
  }

  /// Whether the sky is seen in a direction.
  [[nodiscard]] bool sees_sky(const RealQuestion& lit_past, const Eigen::Vector3f& direction) const {
    return above_horizon(point_, direction) &&
           !object_.occluded(leaving_ray(point_, direction, light_.sky_distance_m), counts_) &&
           reaches_past(lit_past, direction, light_.sky_distance_m, counts_);
  }

  /// What comes from the direction in which the path goes on.
  struct Incoming {
    Rgb sky = Rgb::Zero(), suns = Rgb::Zero(), lamps = Rgb::Zero(), surfaces = Rgb::Zero();
  };
  [[nodiscard]] Incoming incoming(const RealQuestion& lit_past, const RealQuestion& by,
                                  const Eigen::Vector3f& direction, float spread) const {
    Incoming in;
    if (!bounces_matter(by)) {
      if (!leaves_out_sky(light_, counts_) && sees_sky(lit_past, direction)) find_far(direction, in);
      return in;
    }
    Ray ray = leaving_ray(point_, direction, light_.sky_distance_m);
    const bool is_same = same(lit_past, by);
    const std::optional<SurfacePoint> hit = real_hit(by, direction, light_.sky_distance_m, counts_);
    if (hit) ray.far_m = hit->distance_m;
    // Only the nearer one matters for bounce light, but the sky is hidden by the object at any distance.
    const std::optional<SurfacePoint> object_hit = object_.nearest(
        is_same || !hit ? ray : Ray{ray.origin_m, ray.direction, light_.sky_distance_m}, counts_);
    const bool object_first = object_hit && (!hit || object_hit->distance_m <= hit->distance_m);
    const bool sky_reaches =
        !object_hit && (is_same ? !hit : reaches_past(lit_past, direction, light_.sky_distance_m, counts_));
    if (sky_reaches) find_far(direction, in);
    if (!object_first && !hit) return in;
    const SurfacePoint& first = object_first ? *object_hit : *hit;
    const FoundEmission emission =
        sends_photograph(light_, first) && only_paths_find_photograph(by)
            ? FoundEmission{light_.environment->radiance(first.position_m.normalized()), true}
            : emission_found(light_, point_, direction, first);
    if (!emission.is_lamp)
      in.surfaces += emission.radiance;
    else if (emission_hits(lit_past, by) == EmissionHits::found)
      in.lamps += emission.radiance;
    in.surfaces += arriving({*by.geometry, &object_, counts_}, first, spread, light_, sampler_, 0);
    return in;
  }

 private:
  void find_far(const Eigen::Vector3f& direction, Incoming& in) const {
    in.sky = sky_found(light_, point_, direction);
    in.suns = suns_found(light_, point_, direction);
  }
  [[nodiscard]] bool emits(const RealQuestion& by) const {
    return by.geometry->emits() || light_.photographed != nullptr;
  }
  /// Asked from elsewhere, a ray does not meet the place that a light sample chose from the object's own
  /// point.
  [[nodiscard]] bool only_paths_find_photograph(const RealQuestion& by) const { return by.start != &point_; }

  const Geometry& object_;
  const SurfacePoint& point_;
  const Light& light_;
  const Sampler& sampler_;
  RayCounts* counts_;
};

}  // namespace

Split leaving_object(const ObjectQuestions& ask, const Geometry& object, const SurfacePoint& point,
                     const Light& light, const Sampler& sampler, RayCounts* counts) {
  const ObjectLight from(object, point, light, sampler, counts);
  const bool is_mirror = is_glossy(scatterer(point));
  const bool mirrors_apart =
      is_mirror && !(same(ask.mirrored, ask.lit_past) && same(ask.mirrored, ask.bounced));
  Split out;
  out.direct = point.emission;
  from.each_sample(ask.lit_past, from.emission_hits(ask.lit_past, ask.bounced),
                   [&](const LightSample& sample) {
                     out.direct += sample.radiance;
                     if (!mirrors_apart) out.mirrored += sample.mirrored;
                   });
  const bool asks_mirror_apart = mirrors_apart && ask.mirrored.geometry != nullptr;
  if (asks_mirror_apart)
    from.each_sample(ask.mirrored, from.emission_hits(ask.mirrored, ask.mirrored),
                     [&](const LightSample& sample) { out.mirrored += sample.mirrored; });
  const auto sky_rays = static_cast<float>(light.sky_rays);
  for (int more = 1; more < light.sky_rays; ++more) {
    const Eigen::Vector3f chosen =
        turned_direction(point.normal, sampler.point(dimension::direction(0)), more, light.sky_rays);
    const Eigen::Vector3f direction = leaving_direction(point, chosen);
    if (from.sees_sky(ask.lit_past, direction))
      out.direct += diffuse_weight(point, chosen) * light.sky(direction) / sky_rays;
  }
  const auto next = scatter(light, point, sampler.point(dimension::direction(0)));
  if (!next) return out;
  const Rgb diffuse = next->diffuse();
  if (!is_mirror || (diffuse > 0.0F).any() || !mirrors_apart || finds_suns(light, point)) {
    const auto in = from.incoming(ask.lit_past, ask.bounced, next->direction, next->spread);
    out.direct += diffuse * in.sky / sky_rays + diffuse * in.lamps + next->weight * in.suns;
    out.bounce += diffuse * in.surfaces;
    if (is_mirror && !mirrors_apart) out.mirrored += next->specular * (in.sky + in.lamps + in.surfaces);
  }
  if (!asks_mirror_apart) return out;
  const auto in = from.incoming(ask.mirrored, ask.mirrored, next->direction, next->spread);
  out.mirrored += next->specular * (in.sky + in.lamps + in.surfaces);
  return out;
}

}  // namespace seamline::renderer
