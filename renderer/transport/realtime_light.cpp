#include "renderer/transport/realtime_light.h"

#include "raytracer/light/light_sample.h"
#include "raytracer/tracing/surface_point.h"

namespace seamline::renderer {
namespace {

/// Numbers of a light's questions: each sun, each lamp or all of them in one, then the rest.
struct Questions {
  int suns = 0, lamps = 0, others = 0;
  bool each_lamp = false;

  explicit Questions(const RealtimeWorld& world)
      : suns(static_cast<int>(world.light.suns.size())), each_lamp(!world.each_lamp.empty()) {
    const int all = light_samples(world.light);
    lamps = each_lamp ? static_cast<int>(world.each_lamp.size()) : (world.light.lamps.empty() ? 0 : 1);
    others = all - suns - (world.light.lamps.empty() ? 0 : 1);
  }
  [[nodiscard]] int has_shape() const { return suns + lamps; }  ///< those that come first may have maps
  [[nodiscard]] int count() const { return suns + lamps + others; }
};

std::optional<LightSample> ask(const RealtimeWorld& world, const Questions& questions, int number,
                               const SurfacePoint& point, const Sampler& sampler) {
  const bool is_lamp = number >= questions.suns && number < questions.has_shape();
  if (is_lamp && questions.each_lamp)
    return light_sample(world.each_lamp[number - questions.suns], 0, point, Rgb::Ones(), sampler, 0,
                        EmissionHits::unknown);
  if (number >= questions.has_shape()) number -= questions.lamps - (world.light.lamps.empty() ? 0 : 1);
  return light_sample(world.light, number, point, Rgb::Ones(), sampler, 0, EmissionHits::unknown);
}

/// The map of a question's light; null where there is none.
const ShadowMap* map_of(const std::optional<ShadowMaps>& maps, const Questions& questions, int number) {
  if (!maps) return nullptr;
  if (number < questions.suns) return &maps->suns[number];
  if (questions.each_lamp && number < questions.has_shape()) return &maps->lamps[number - questions.suns];
  return nullptr;
}

float arriving_at(const ShadowMap& map, const RealtimeWorld& world, const SurfacePoint& point,
                  const Sampler& sampler) {
  const float turn =
      world.pipeline.shadow_filter == ShadowFilter::pcss ? sampler.point(dimension::sun(0))[1] : 0.0F;
  return arriving(map, world.lookup(), point.position_m, point.normal, turn);
}

SurfacePoint of_truths_material(const UncoveredPoint& point) {
  SurfacePoint receiver = *point.receiver;
  receiver.albedo = point.shaded_as->albedo;
  receiver.f0 = point.shaded_as->f0;
  receiver.alpha = point.shaded_as->alpha;
  receiver.f90 = point.shaded_as->f90;
  receiver.to_viewer = point.shaded_as->to_viewer;
  return receiver;
}

/// Irradiance of a question's light on a plane that faces it, as luminance: what a dark layer weighs it by.
float weight_of(const RealtimeWorld& world, const Questions& questions, int number,
                const Eigen::Vector3f& point_m) {
  const auto luminance = [](const Rgb& light) {
    return 0.2126F * light[0] + 0.7152F * light[1] + 0.0722F * light[2];
  };
  if (number < questions.suns) return luminance(world.light.suns[number].irradiance_w_m2);
  const Lamp& lamp = world.each_lamp[number - questions.suns].lamps.front();
  const Eigen::Vector3f away = point_m - lamp.position_m;
  const float distance_m = away.norm();
  return distance_m > 0.0F ? luminance(intensity_towards(lamp, away / distance_m)) / (distance_m * distance_m)
                           : 0.0F;
}

/// Adds up the light off the object.
class Uncovered {
 public:
  Uncovered(std::span<const UncoveredPoint> points, const Geometry& object, const RealtimeWorld& world,
            const Answers& answers, std::span<RadiancePair> pairs, LightRays& rays, RayCounts* counts)
      : points_(points),
        object_(object),
        real_(*points.front().lit.geometry),
        world_(world),
        questions_(world),
        real_by_map_(answers.real_lit == Who::depth),
        object_by_map_(answers.receiver == Who::depth),
        object_by_field_(object_by_map_ && world.fields),
        pairs_(pairs),
        rays_(rays),
        counts_(counts) {}

  void add_light() {
    rays_.clear();
    for (int number = 0; number < questions_.count(); ++number) {
      const ShadowMap* past_real = real_by_map_ ? map_of(world_.real, questions_, number) : nullptr;
      const ShadowMap* past_object = object_by_map_ ? map_of(world_.object, questions_, number) : nullptr;
      for (std::size_t i = 0; i < points_.size(); ++i) {
        const SurfacePoint receiver = of_truths_material(points_[i]);
        const auto sample = ask(world_, questions_, number, receiver, points_[i].sampler);
        if (!sample) continue;
        add(i, receiver, sample->direction, sample->far_m, sample->radiance, past_real, past_object);
      }
      const Coherence coherence = number < questions_.suns ? Coherence::together : Coherence::scattered;
      trace(past_real == nullptr, past_object == nullptr && !object_by_field_, coherence, &Split::direct);
    }
    add_sky();
    if (object_by_field_) shade_by_field();
  }

  void add_layer() {
    rays_.clear();
    std::vector<float> all(points_.size(), 0.0F);
    for (int number = 0; number < questions_.has_shape(); ++number) {
      const ShadowMap* past_object = object_by_map_ ? map_of(world_.object, questions_, number) : nullptr;
      for (std::size_t i = 0; i < points_.size(); ++i) {
        const SurfacePoint& receiver = *points_[i].receiver;
        const auto sample = ask(world_, questions_, number, receiver, points_[i].sampler);
        const float weight = weight_of(world_, questions_, number, receiver.position_m);
        all[i] += weight;
        if (sample)
          add(i, receiver, sample->direction, sample->far_m, Rgb::Constant(weight), nullptr, past_object);
      }
      trace(!real_by_map_, past_object == nullptr, Coherence::together, &Split::direct);
    }
    const auto opacity = static_cast<float>(world_.pipeline.shadow_opacity);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Rgb kept = pairs_[i].without_object.direct - pairs_[i].with_object.direct;
      const float share = all[i] > 0.0F ? kept[0] / all[i] : 0.0F;
      pairs_[i] = {{.direct = Rgb::Ones()}, {.direct = Rgb::Constant(1.0F - opacity * share)}};
    }
  }

 private:
  /// All light off the object past the field's object, whichever way it comes; what emits is not shaded.
  void shade_by_field() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const SurfacePoint& receiver = *points_[i].receiver;
      const Rgb arrives = field_shadow(*world_.fields, receiver.position_m, receiver.normal);
      const Split& without = pairs_[i].without_object;
      const Rgb emission = points_[i].shaded_as->emission;
      pairs_[i].with_object = {.direct = emission + arrives * (without.direct - emission),
                               .bounce = arrives * without.bounce};
    }
  }

  void add(std::size_t i, const SurfacePoint& receiver, const Eigen::Vector3f& direction, float far_m,
           const Rgb& radiance, const ShadowMap* past_real, const ShadowMap* past_object) {
    const UncoveredPoint& point = points_[i];
    const float real =
        past_real != nullptr ? arriving_at(*past_real, world_, *point.lit.start, point.sampler) : 1.0F;
    if (!(real > 0.0F)) return;
    const float object =
        past_object != nullptr ? arriving_at(*past_object, world_, receiver, point.sampler) : 1.0F;
    rays_.add(receiver, point.lit, direction, far_m, {i, real * radiance, object});
  }

  void trace(bool asks_real, bool asks_object, Coherence coherence, Rgb Split::*part) {
    if (rays_.empty()) return;
    if (asks_real) rays_.drop_blocked_by_real(real_, coherence, counts_);
    for (const LightRays::Arriving& light : rays_.arriving())
      pairs_[light.index].without_object.*part += light.radiance;
    if (asks_object) rays_.drop_blocked_by_object(object_, coherence, counts_);
    for (const LightRays::Arriving& light : rays_.arriving())
      pairs_[light.index].with_object.*part += light.past_object * light.radiance;
    rays_.clear();
  }

  void add_sky() {
    const Light& light = world_.light;
    if (light.skips_sky) return;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const SurfacePoint receiver = of_truths_material(points_[i]);
      const auto next = scatter(light, receiver, points_[i].sampler.point(dimension::direction(0)));
      if (next)
        rays_.add(receiver, points_[i].lit, next->direction, light.sky_distance_m,
                  {i, next->diffuse() * sky_found(light, receiver, next->direction)});
    }
    // As in `direct_on_uncovered`: a constant sky is smooth and may be filtered.
    trace(true, !object_by_field_, Coherence::scattered, light.environment ? &Split::direct : &Split::bounce);
  }

  std::span<const UncoveredPoint> points_;
  const Geometry& object_;
  const Geometry& real_;
  const RealtimeWorld& world_;
  const Questions questions_;
  bool real_by_map_, object_by_map_, object_by_field_;
  std::span<RadiancePair> pairs_;
  LightRays& rays_;
  RayCounts* counts_;
};

}  // namespace

void realtime_on_uncovered(std::span<const UncoveredPoint> points, const Geometry& object,
                           const RealtimeWorld& world, const Answers& answers, std::span<RadiancePair> pairs,
                           LightRays& rays, RayCounts* counts) {
  if (points.empty()) return;
  for (std::size_t i = 0; i < points.size(); ++i) pairs[i] = {};
  Uncovered uncovered(points, object, world, answers, pairs, rays, counts);
  if (world.is_dark_layer()) return uncovered.add_layer();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Split emitted{.direct = points[i].shaded_as->emission};
    pairs[i] = {emitted, emitted};
  }
  uncovered.add_light();
}

void realtime_on_object(std::span<const ObjectPoint> points, const Geometry& object,
                        const RealtimeWorld& world, std::span<Rgb> direct, LightRays& rays,
                        RayCounts* counts) {
  for (std::size_t i = 0; i < points.size(); ++i) direct[i] = points[i].point->emission;
  if (points.empty()) return;
  if (world.fields) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const SurfacePoint& point = *points[i].point;
      direct[i] +=
          point.albedo * inverse_pi * field_irradiance(*world.fields, point.position_m, point.normal);
    }
    return;
  }
  const Geometry& real = *points.front().lit_past.geometry;
  const Questions questions(world);
  const auto trace = [&](bool by_rays, Coherence coherence) {
    if (rays.empty()) return;
    if (by_rays) rays.drop_blocked_by_object(object, coherence, counts);
    if (by_rays) rays.drop_blocked_by_real(real, coherence, counts);
    for (const LightRays::Arriving& light : rays.arriving()) direct[light.index] += light.radiance;
    rays.clear();
  };
  rays.clear();
  for (int number = 0; number < questions.count(); ++number) {
    const ShadowMap* past_real = map_of(world.real, questions, number);
    const ShadowMap* past_object = map_of(world.object, questions, number);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ObjectPoint& one = points[i];
      const auto sample = ask(world, questions, number, *one.point, one.sampler);
      if (!sample) continue;
      float share = 1.0F;
      if (past_real != nullptr) share *= arriving_at(*past_real, world, *one.lit_past.start, one.sampler);
      if (past_object != nullptr && share > 0.0F)
        share *= arriving_at(*past_object, world, *one.point, one.sampler);
      if (share > 0.0F)
        rays.add(*one.point, one.lit_past, sample->direction, sample->far_m, {i, share * sample->radiance});
    }
    trace(past_real == nullptr, number < questions.suns ? Coherence::together : Coherence::scattered);
  }
  if (world.light.skips_sky) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& point = *points[i].point;
    if (const auto next = scatter(world.light, point, points[i].sampler.point(dimension::direction(0))))
      rays.add(point, points[i].lit_past, next->direction, world.light.sky_distance_m,
               {i, next->diffuse() * sky_found(world.light, point, next->direction)});
  }
  trace(true, Coherence::scattered);
}

}  // namespace seamline::renderer
