#include "renderer/convergence/convergence_light.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <mutex>

#include "renderer/common/parallel.h"
#include "renderer/common/sampler.h"
#include "renderer/light/light_sample.h"
#include "support/running/progress.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

constexpr std::array<int, 3> rays_of_a_sample = {1, 2, 4};
constexpr std::array<int, 4> sample_counts = {1, 4, 16, 64};
constexpr int reference_spp = 1024;
constexpr std::uint64_t ray_seed_step = 1000003;

/// Light that is to arrive at a surface, in the pixel that shows it.
struct Asked {
  std::size_t pixel = 0;
  Ray ray;
  /// Where nothing is in the way; and, of rays that look for what glows, what they weigh it by.
  Rgb radiance = Rgb::Zero();
};

/// Questions of one row of pixels, answered together.
struct RowQuestions {
  std::vector<Asked> past_everything;  ///< whether anything is in the way
  struct Found {
    Asked asked;
    std::function<Rgb(const SurfacePoint& hit)> glow;
  };
  std::vector<Found> what_glows;  ///< what is met
};

using Strategy = std::function<void(const SurfacePoint& point, const Sampler& sampler, std::size_t pixel,
                                    RowQuestions& questions)>;
struct NamedStrategy {
  std::string light, name;
  Strategy ask;
};

/// What goes on to the camera of light that comes from a direction; BSDF times cosine.
Rgb sent_on(const SurfacePoint& point, const Eigen::Vector3f& direction) {
  if (sun_cosine(point, direction) <= 0.0F) return Rgb::Zero();
  return scattered_share(scatterer(point), point.normal, point.to_viewer, direction);
}

/// By the renderer's own light sampler, which weighs it against what surfaces find.
Strategy by_light_sample(const Light& light, GlowHits hits) {
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
    const auto next = scatter(point, sampler.point(dimension::direction(0)));
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

// Surfaces that glow.

Strategy glow_by_area(const Light& light) {
  return [&light](const SurfacePoint& point, const Sampler& sampler, std::size_t pixel,
                  RowQuestions& questions) {
    const auto place =
        light.glowing->sample(sampler.point(dimension::glow_choice(0))[0], sampler.point(dimension::glow(0)));
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
Strategy glow_by_surface(const Light& light, bool weighted) {
  return [&light, weighted](const SurfacePoint& point, const Sampler& sampler, std::size_t pixel,
                            RowQuestions& questions) {
    const auto next = scatter(point, sampler.point(dimension::direction(0)));
    if (!next) return;
    const Eigen::Vector3f direction = next->direction;
    const auto glow = [&light, weighted, point, direction](const SurfacePoint& hit) -> Rgb {
      if (!(light.glowing->density_m2(hit) > 0.0F)) return Rgb::Zero();
      return weighted ? glow_found(light, point, direction, hit).radiance : hit.emission;
    };
    questions.what_glows.push_back({{pixel, leaving_ray(point, direction, endless), next->weight}, glow});
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

/// Lights of a scene, each of one kind alone.
struct LightsApart {
  std::optional<Light> map, sky, glowing, lamps;
};

LightsApart lights_apart(const Light& light) {
  LightsApart apart;
  Light none = light;
  none.suns.clear(), none.lamps.clear();
  none.environment = nullptr, none.glowing = nullptr;
  none.environment_radiance = Rgb::Zero();
  if (light.environment) (apart.map = none)->environment = light.environment;
  if ((light.environment_radiance > 0.0F).any())
    (apart.sky = none)->environment_radiance = light.environment_radiance;
  if (light.glowing) (apart.glowing = none)->glowing = light.glowing;
  if (!light.lamps.empty()) (apart.lamps = none)->lamps = light.lamps;
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
    all.push_back({kind, "both", both(by_light_sample(light, GlowHits::found), sky_by_surface(light, less))});
  }
  if (lights.sky) {
    if (glossy) all.push_back({"sky", "cosine", sky_by_cosine(*lights.sky)});
    all.push_back({"sky", surface, sky_by_surface(*lights.sky, as_it_is(*lights.sky))});
  }
  if (lights.glowing) {
    const Light& light = *lights.glowing;
    const std::string kind = "glowing surfaces";
    all.push_back({kind, "area", glow_by_area(light)});
    all.push_back({kind, surface, glow_by_surface(light, false)});
    all.push_back(
        {kind, "both", both(by_light_sample(light, GlowHits::found), glow_by_surface(light, true))});
  }
  if (lights.lamps) {
    all.push_back({"lamps", "one, evenly", lamp_chosen_evenly(*lights.lamps)});
    all.push_back({"lamps", "every one", every_lamp(*lights.lamps)});
    all.push_back({"lamps", "one, by what it sends", by_light_sample(*lights.lamps, GlowHits::found)});
  }
  return all;
}

/// Mean radiance of every pixel, row by row, and what it cost.
struct Picture {
  std::vector<Eigen::Array3d> radiance;
  std::vector<char> shows_surface;
  std::int64_t traced = 0;
  double seconds = 0;
};

class Sampling {
 public:
  Sampling(const Geometry& truth, const Camera& camera, int threads)
      : truth_(truth), camera_(camera), threads_(threads) {}

  [[nodiscard]] Picture picture(const Strategy& ask, int rays, int spp, std::uint64_t seed) const {
    const auto pixels =
        static_cast<std::size_t>(camera_.width_px) * static_cast<std::size_t>(camera_.height_px);
    Picture out{std::vector<Eigen::Array3d>(pixels, Eigen::Array3d::Zero()), std::vector<char>(pixels, 0)};
    const double before = static_cast<double>(std::clock());
    std::mutex counting;
    parallel_for(camera_.height_px, threads_, [&](int y) {
      RayCounts counts;
      for (int sample = 0; sample < spp; ++sample) add_row(ask, rays, {0, y, sample}, seed, out, counts);
      const std::lock_guard lock(counting);
      out.traced += counts.traced;
    });
    out.seconds = (static_cast<double>(std::clock()) - before) / CLOCKS_PER_SEC;
    for (Eigen::Array3d& radiance : out.radiance) radiance /= static_cast<double>(spp) * rays;
    return out;
  }

 private:
  void add_row(const Strategy& ask, int rays, const SampleId& first, std::uint64_t seed, Picture& out,
               RayCounts& counts) const {
    const auto width = static_cast<std::size_t>(camera_.width_px);
    std::vector<Ray> camera_rays(width);
    for (std::size_t x = 0; x < width; ++x)
      camera_rays[x] = camera_ray(camera_, static_cast<int>(x), first.y,
                                  Sampler(seed, static_cast<int>(x), first.y, first.number));
    std::vector<std::optional<SurfacePoint>> hits(width);
    truth_.nearest(camera_rays, hits, Coherence::together, &counts);
    RowQuestions questions;
    for (std::size_t x = 0; x < width; ++x) {
      if (!hits[x]) continue;
      const std::size_t pixel = static_cast<std::size_t>(first.y) * width + x;
      out.shows_surface[pixel] = 1;
      for (int ray = 0; ray < rays; ++ray)
        ask(*hits[x],
            Sampler(seed + static_cast<std::uint64_t>(ray) * ray_seed_step, static_cast<int>(x), first.y,
                    first.number),
            pixel, questions);
    }
    answer(questions, out, counts);
  }

  void answer(const RowQuestions& questions, Picture& out, RayCounts& counts) const {
    std::vector<Ray> rays;
    for (const Asked& asked : questions.past_everything) rays.push_back(asked.ray);
    std::vector<std::uint8_t> blocked(rays.size());
    truth_.occluded(rays, blocked, Coherence::scattered, &counts);
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (blocked[i] == 0)
        out.radiance[questions.past_everything[i].pixel] +=
            questions.past_everything[i].radiance.cast<double>();
    rays.clear();
    for (const auto& found : questions.what_glows) rays.push_back(found.asked.ray);
    std::vector<std::optional<SurfacePoint>> hits(rays.size());
    truth_.nearest(rays, hits, Coherence::scattered, &counts);
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (hits[i])
        out.radiance[questions.what_glows[i].asked.pixel] +=
            (questions.what_glows[i].asked.radiance * questions.what_glows[i].glow(*hits[i])).cast<double>();
  }

  const Geometry& truth_;
  const Camera& camera_;
  const int threads_;
};

double mean_radiance(const Picture& picture) {
  double sum = 0, pixels = 0;
  for (std::size_t i = 0; i < picture.radiance.size(); ++i)
    if (picture.shows_surface[i] != 0) sum += picture.radiance[i].mean(), ++pixels;
  return pixels > 0 ? sum / pixels : 0;
}

/// Over the pixels that the reference shows a surface in, over its mean.
double relative_error(const Picture& picture, const Picture& reference) {
  double sum = 0, pixels = 0;
  for (std::size_t i = 0; i < picture.radiance.size(); ++i)
    if (reference.shows_surface[i] != 0)
      sum += (picture.radiance[i] - reference.radiance[i]).square().mean(), ++pixels;
  return std::sqrt(sum / std::max(pixels, 1.0)) / mean_radiance(reference);
}

LightResult::Agreement agreement(const NamedStrategy& strategy, const Picture& picture,
                                 const Picture& reference) {
  const double mean = mean_radiance(reference);
  double sum = 0, squares = 0, pixels = 0;
  for (std::size_t i = 0; i < picture.radiance.size(); ++i) {
    if (reference.shows_surface[i] == 0) continue;
    const double excess = (picture.radiance[i] - reference.radiance[i]).mean() / mean;
    sum += excess, squares += excess * excess, ++pixels;
  }
  const double excess = sum / std::max(pixels, 1.0);
  return {
      strategy.light, strategy.name, excess,
      std::sqrt(std::max(0.0, squares / std::max(pixels, 1.0) - excess * excess) / std::max(pixels, 1.0))};
}

}  // namespace

LightResult measure_light(const ConvergenceSubject& subject) {
  const Geometry truth = subject.scene.geometry(true, {1, 2, 3});
  const LightsApart lights = lights_apart(subject.scene.light);
  const std::vector<NamedStrategy> strategies = strategies_of(lights, truth.is_glossy());
  if (strategies.empty())
    throw input_error({.file = subject.study.file.string(),
                       .field = "--parts light",
                       .wanted = "a scene with a sky, an environment map, lamps or surfaces that glow",
                       .found = "suns alone, which one ray finds"});
  const Sampling sampling(truth, subject.scene.camera, subject.threads);
  LightResult result{.rows = {}, .agreements = {}, .reference_spp = reference_spp};
  double work = 0;
  for (const int rays : rays_of_a_sample)
    for (const int spp : sample_counts) work += rays * spp;
  Progress progress(stimulus_id(subject.stimulus) + " light",
                    static_cast<double>(strategies.size()) * (work + reference_spp));
  const std::uint64_t seed = subject.study.seed;
  for (std::size_t i = 0; i < strategies.size(); ++i) {
    const std::string& light = strategies[i].light;
    std::size_t last = i;
    while (last + 1 < strategies.size() && strategies[last + 1].light == light) ++last;
    const Picture reference =
        sampling.picture(strategies[last].ask, 1, reference_spp, seed + reference_seed_offset);
    progress.advance(static_cast<double>(last - i + 1) * reference_spp, light + " reference");
    for (; i <= last; ++i) {
      for (const int rays : rays_of_a_sample)
        for (const int spp : sample_counts) {
          const Picture picture = sampling.picture(strategies[i].ask, rays, spp, seed);
          result.rows.push_back({.light = light,
                                 .strategy = strategies[i].name,
                                 .rays = rays,
                                 .spp = spp,
                                 .seconds = picture.seconds,
                                 .traced = picture.traced,
                                 .error = relative_error(picture, reference)});
          if (rays == rays_of_a_sample.back() && spp == sample_counts.back())
            result.agreements.push_back(agreement(strategies[i], picture, reference));
          progress.advance(rays * spp, light + " by " + strategies[i].name);
        }
    }
    --i;
  }
  return result;
}

}  // namespace seamline::renderer
