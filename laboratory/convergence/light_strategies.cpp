#include "laboratory/convergence/light_strategies.h"

#include <algorithm>
#include <cmath>

#include "raytracer/light/light_sample.h"
#include "raytracer/tracing/geometry.h"

namespace seamline::renderer {
namespace {

/// What goes on to the camera of light that comes from a direction; BSDF times cosine.
Rgb sent_on(const SurfacePoint& point, const Eigen::Vector3f& direction) {
  return scattered_share_above(point, direction);
}

/// By the renderer's own light sampler, which weighs it against what surfaces find.
Strategy by_light_sample(const Light& light, EmissionHits hits) {
  return [&light, hits](const SurfacePoint& point, const Sampler& sampler, std::size_t pixel,
                        RowQuestions& questions) {
    if (const auto sample = light_sample(light, 0, point, Rgb::Ones(), sampler, 0, hits))
      questions.past_everything.push_back(
          {pixel, leaving_ray(point, sample->direction, sample->far_m), sample->total()});
  };
}

Strategy both(Strategy one, Strategy other) {
  return [one = std::move(one), other = std::move(other)](const SurfacePoint& point, const Sampler& sampler,
                                                          std::size_t pixel, RowQuestions& questions) {
    one(point, sampler, pixel, questions);
    other(point, sampler, pixel, questions);
  };
}

// The environment.

Strategy map_by_importance(const Light& light) {
  return [&light](const SurfacePoint& point, const Sampler& sampler, std::size_t pixel,
                  RowQuestions& questions) {
    const auto chosen = light.environment->sample(sampler.point(dimension::environment(0)));
    if (!(chosen.density_sr > 0.0F)) return;
    const Rgb radiance = sent_on(point, chosen.direction) * light.sky(chosen.direction) / chosen.density_sr;
    if ((radiance > 0.0F).any())
      questions.past_everything.push_back(
          {pixel, leaving_ray(point, chosen.direction, light.sky_distance_m), radiance});
  };
}

/// `radiance_from`: of the sky, as the direction of a surface finds it.
Strategy sky_by_surface(const Light& light,
                        std::function<Rgb(const SurfacePoint&, const Eigen::Vector3f&)> radiance_from) {
  return [&light, radiance_from = std::move(radiance_from)](const SurfacePoint& point, const Sampler& sampler,
                                                            std::size_t pixel, RowQuestions& questions) {
    const auto next = scatter(light, point, sampler.point(dimension::direction(0)));
    if (!next) return;
    questions.past_everything.push_back({pixel, leaving_ray(point, next->direction, light.sky_distance_m),
                                         next->weight * radiance_from(point, next->direction)});
  };
}

Strategy sky_by_cosine(const Light& light) {
  return [&light](const SurfacePoint& point, const Sampler& sampler, std::size_t pixel,
                  RowQuestions& questions) {
    const Eigen::Vector3f direction = cosine_weighted(point.normal, sampler.point(dimension::direction(0)));
    const float density_sr = inverse_pi * point.normal.dot(direction);
    if (!(density_sr > 0.0F)) return;
    const Rgb radiance = sent_on(point, direction) * light.sky(direction) / density_sr;
    if ((radiance > 0.0F).any())
      questions.past_everything.push_back(
          {pixel, leaving_ray(point, direction, light.sky_distance_m), radiance});
  };
}

// Surfaces that emit.

Strategy emission_by_area(const Light& light) {
  return [&light](const SurfacePoint& point, const Sampler& sampler, std::size_t pixel,
                  RowQuestions& questions) {
    const auto place = light.emitters->sample(sampler.point(dimension::emission_choice(0))[0],
                                              sampler.point(dimension::emission(0)));
    const Eigen::Vector3f to_place = place.position_m - point.position_m;
    const float distance_m = to_place.norm();
    if (!(distance_m > 0.0F)) return;
    const Eigen::Vector3f direction = to_place / distance_m;
    const float density_sr =
        place.density_m2 * distance_m * distance_m / std::abs(place.normal.dot(direction));
    const Rgb radiance = sent_on(point, direction) * place.radiance / density_sr;
    constexpr float before_lamp = 1.0F - 1e-4F;
    if (std::isfinite(density_sr) && density_sr > 0.0F && (radiance > 0.0F).any())
      questions.past_everything.push_back(
          {pixel, leaving_ray(point, direction, distance_m * before_lamp), radiance});
  };
}

/// `weighted`: less what light samples count of it.
Strategy emission_by_surface(const Light& light, bool weighted) {
  return [&light, weighted](const SurfacePoint& point, const Sampler& sampler, std::size_t pixel,
                            RowQuestions& questions) {
    const auto next = scatter(light, point, sampler.point(dimension::direction(0)));
    if (!next) return;
    const Eigen::Vector3f direction = next->direction;
    const auto emission = [&light, weighted, point, direction](const SurfacePoint& hit) -> Rgb {
      if (!(light.emitters->density_m2(hit) > 0.0F)) return Rgb::Zero();
      return weighted ? emission_found(light, point, direction, hit).radiance : hit.emission;
    };
    questions.emission_questions.push_back(
        {{pixel, leaving_ray(point, direction, endless), next->weight}, emission});
  };
}

// Lamps without size.

void ask_lamp(const Lamp& lamp, float probability, const SurfacePoint& point, std::size_t pixel,
              RowQuestions& questions) {
  const Eigen::Vector3f to_lamp = lamp.position_m - point.position_m;
  const float distance_m = to_lamp.norm();
  if (!(distance_m > 0.0F)) return;
  const Eigen::Vector3f direction = to_lamp / distance_m;
  const Rgb radiance = sent_on(point, direction) * intensity_towards(lamp, -direction) /
                       (distance_m * distance_m * probability);
  if ((radiance > 0.0F).any())
    questions.past_everything.push_back(
        {pixel, leaving_ray(point, direction, distance_m * (1.0F - 1e-4F)), radiance});
}

Strategy lamp_chosen_evenly(const Light& light) {
  return [&light](const SurfacePoint& point, const Sampler& sampler, std::size_t pixel,
                  RowQuestions& questions) {
    const auto count = static_cast<float>(light.lamps.size());
    const auto chosen = std::min(light.lamps.size() - 1,
                                 static_cast<std::size_t>(sampler.point(dimension::lamp(0))[0] * count));
    ask_lamp(light.lamps[chosen], 1.0F / count, point, pixel, questions);
  };
}

Strategy every_lamp(const Light& light) {
  return [&light](const SurfacePoint& point, const Sampler&, std::size_t pixel, RowQuestions& questions) {
    for (const Lamp& lamp : light.lamps) ask_lamp(lamp, 1.0F, point, pixel, questions);
  };
}

// Suns with size.

Strategy suns_by_disc(const Light& light, SunHits hits) {
  return [&light, hits](const SurfacePoint& point, const Sampler& sampler, std::size_t pixel,
                        RowQuestions& questions) {
    for (int number = 0; number < light_samples(light); ++number)
      if (const auto sample =
              light_sample(light, number, point, Rgb::Ones(), sampler, 0, EmissionHits::unknown, hits))
        questions.past_everything.push_back(
            {pixel, leaving_ray(point, sample->direction, sample->far_m), sample->total()});
  };
}

Rgb suns_in(const Light& light, const Eigen::Vector3f& direction) {
  Rgb radiance = Rgb::Zero();
  for (const Sun& sun : light.suns) radiance += disc_radiance(sun, direction);
  return radiance;
}

}  // namespace

LightsApart lights_apart(const Light& light) {
  LightsApart apart;
  Light none = light;
  none.suns.clear(), none.lamps.clear();
  none.environment = nullptr, none.emitters = nullptr;
  none.environment_radiance = Rgb::Zero();
  if (light.environment) (apart.map = none)->environment = light.environment;
  if ((light.environment_radiance > 0.0F).any())
    (apart.sky = none)->environment_radiance = light.environment_radiance;
  if (has_emitters(light)) (apart.emitters = none)->emitters = light.emitters;
  if (!light.lamps.empty()) (apart.lamps = none)->lamps = light.lamps;
  if (std::any_of(light.suns.begin(), light.suns.end(),
                  [](const Sun& sun) { return sun.angular_radius_rad > 0.0F; })) {
    (apart.suns = none)->suns = light.suns;
    apart.suns->skips_sky = false;  // or nobody looks for them
  }
  return apart;
}

std::vector<NamedStrategy> strategies_of(const LightsApart& lights, bool glossy) {
  std::vector<NamedStrategy> all;
  const std::string surface = glossy ? "visible normals" : "cosine";
  const auto as_it_is = [](const Light& light) {
    return [&light](const SurfacePoint&, const Eigen::Vector3f& direction) { return light.sky(direction); };
  };
  if (lights.map) {
    const Light& light = *lights.map;
    const std::string kind = "environment map";
    all.push_back({kind, "map", map_by_importance(light)});
    if (glossy) all.push_back({kind, "cosine", sky_by_cosine(light)});
    all.push_back({kind, surface, sky_by_surface(light, as_it_is(light))});
    const auto less = [&light](const SurfacePoint& point, const Eigen::Vector3f& direction) {
      return sky_found(light, point, direction);
    };
    all.push_back(
        {kind, "both", both(by_light_sample(light, EmissionHits::found), sky_by_surface(light, less))});
  }
  if (lights.sky) {
    if (glossy) all.push_back({"sky", "cosine", sky_by_cosine(*lights.sky)});
    all.push_back({"sky", surface, sky_by_surface(*lights.sky, as_it_is(*lights.sky))});
  }
  if (lights.suns) {
    const Light& light = *lights.suns;
    all.push_back({"suns", "disc", suns_by_disc(light, SunHits::unknown)});
    const auto in_discs = [&light](const SurfacePoint&, const Eigen::Vector3f& direction) {
      return suns_in(light, direction);
    };
    const auto less = [&light](const SurfacePoint& point, const Eigen::Vector3f& direction) {
      return suns_found(light, point, direction);
    };
    if (glossy) {
      all.push_back({"suns", surface, sky_by_surface(light, in_discs)});
      all.push_back({"suns", "both", both(suns_by_disc(light, SunHits::found), sky_by_surface(light, less))});
    }
  }
  if (lights.emitters) {
    const Light& light = *lights.emitters;
    const std::string kind = "glowing surfaces";
    all.push_back({kind, "area", emission_by_area(light)});
    all.push_back({kind, surface, emission_by_surface(light, false)});
    all.push_back(
        {kind, "both", both(by_light_sample(light, EmissionHits::found), emission_by_surface(light, true))});
  }
  if (lights.lamps) {
    all.push_back({"lamps", "one, evenly", lamp_chosen_evenly(*lights.lamps)});
    all.push_back({"lamps", "every one", every_lamp(*lights.lamps)});
    all.push_back({"lamps", "one, by what it sends", by_light_sample(*lights.lamps, EmissionHits::found)});
  }
  return all;
}

}  // namespace seamline::renderer
