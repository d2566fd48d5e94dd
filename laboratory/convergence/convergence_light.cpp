#include "laboratory/convergence/convergence_light.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <mutex>

#include "laboratory/convergence/estimates/estimates.h"
#include "laboratory/convergence/light_strategies.h"
#include "raytracer/common/parallel.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

constexpr std::array<int, 3> rays_of_a_sample = {1, 2, 4};
constexpr std::array<int, 4> sample_counts = {1, 4, 16, 64};
constexpr int reference_spp = 1024;
constexpr std::uint64_t ray_seed_step = 1000003;

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
    const double before = processor_seconds();
    std::mutex counting;
    parallel_for(camera_.height_px, threads_, [&](int y) {
      RayCounts counts;
      for (int sample = 0; sample < spp; ++sample) add_row(ask, rays, {0, y, sample}, seed, out, counts);
      const std::lock_guard lock(counting);
      out.traced += counts.traced;
    });
    out.seconds = processor_seconds() - before;
    for (Eigen::Array3d& radiance : out.radiance) radiance /= static_cast<double>(spp) * rays;
    return out;
  }

 private:
  void add_row(const Strategy& ask, int rays, const SampleId& first, std::uint64_t seed, Picture& out,
               RayCounts& counts) const {
    const std::size_t width = camera_.width_px;
    std::vector<Ray> camera_rays(width);
    for (std::size_t x = 0; x < width; ++x)
      camera_rays[x] = camera_ray(camera_, static_cast<int>(x), first.y,
                                  Sampler(seed, static_cast<int>(x), first.y, first.number));
    std::vector<std::optional<SurfacePoint>> hits(width);
    truth_.nearest(camera_rays, hits, Coherence::together, &counts);
    RowQuestions questions;
    for (std::size_t x = 0; x < width; ++x) {
      if (!hits[x]) continue;
      const std::size_t pixel = first.y * width + x;
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
    for (const AskedLight& asked : questions.past_everything) rays.push_back(asked.ray);
    std::vector<std::uint8_t> blocked(rays.size());
    truth_.occluded(rays, blocked, Coherence::scattered, &counts);
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (blocked[i] == 0)
        out.radiance[questions.past_everything[i].pixel] +=
            questions.past_everything[i].radiance.cast<double>();
    rays.clear();
    for (const auto& found : questions.emission_questions) rays.push_back(found.asked.ray);
    std::vector<std::optional<SurfacePoint>> hits(rays.size());
    truth_.nearest(rays, hits, Coherence::scattered, &counts);
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (hits[i])
        out.radiance[questions.emission_questions[i].asked.pixel] +=
            (questions.emission_questions[i].asked.radiance *
             questions.emission_questions[i].emission(*hits[i]))
                .cast<double>();
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
  const Geometry truth = subject.scene.geometry(true, subject.scene.object_indices());
  const LightsApart lights = lights_apart(subject.scene.light);
  const std::vector<NamedStrategy> strategies = strategies_of(lights, truth.is_glossy());
  if (strategies.empty())
    throw input_error(
        {.file = subject.study.file.string(),
         .field = request_name("parts") + " light",
         .wanted = "a scene with a sky, an environment map, lamps, suns with size or surfaces that glow",
         .found = "hard suns alone, which one ray finds"});
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
