// One composite at a wanted error: fast beside path, the background given.
#include <fmt/format.h>

#include <limits>

#include "renderer/bench.h"
#include "renderer/convergence_runs.h"
#include "renderer/estimator.h"
#include "renderer/stopwatch.h"
#include "renderer/true_error.h"
#include "stimuli/study_file.h"
#include "stimuli/support/assets.h"

namespace seamline {
namespace {

constexpr double wanted_relative_rmse = 0.034;  // of the background's mean radiance

/// What pictures are measured against, and where.
struct GivenBackground {
  StimulusLayers layers;               ///< of the reference; its background is the one given
  ReferenceHalves halves;              ///< the composite from each half of the samples, on that background
  Image mask;                          ///< lit pixels off the object
  int first_spp = 16, most_spp = 256;  ///< where looking for the wanted error begins and ends
  double least_error = 0.002;          ///< likewise of `fast`
  int threads = 1;
  double mean_radiance = 0;  ///< of the background there

  [[nodiscard]] double relative_rmse(const StimulusLayers& trial) const {
    const Image picture = compose(onto_given_background(trial, layers)).picture;
    return true_linear_error(picture, halves, mask).rmse() / mean_radiance;
  }
};

/// Lit: the photograph's surface has at least a hundredth of the mean radiance. Sky is never part: nothing is
/// computed there.
GivenBackground given_background(PathRun reference) {
  GivenBackground given;
  given.mask = off_object_mask(reference);
  given.layers = std::move(reference.layers);
  const auto radiance = [&](std::size_t i) -> double {
    const StimulusSums &a = given.layers.halves[0][i], &b = given.layers.halves[1][i];
    return a.rest + b.rest > 0 ? (a.background + b.background).mean() / (a.rest + b.rest) : 0;
  };
  const auto mean = [&] {
    double sum = 0, pixels = 0;
    for (std::size_t i = 0; i < given.mask.values.size(); ++i)
      if (given.mask.values[i] > 0.5F && radiance(i) > 0) {
        sum += radiance(i);
        ++pixels;
      }
    return pixels > 0 ? sum / pixels : 0;
  };
  const double lit = 0.01 * mean();
  for (std::size_t i = 0; i < given.mask.values.size(); ++i)
    if (radiance(i) <= lit) given.mask.values[i] = 0;
  given.mean_radiance = mean();
  for (std::size_t half = 0; half < 2; ++half)
    given.halves[half] = compose(onto_given_background(half_of(given.layers, half), given.layers)).picture;
  return given;
}

/// The first of ever finer attempts that reaches the wanted error, and what the composite took.
struct Reached {
  std::string how;  ///< e.g. "path, 64 samples"
  double seconds = 0;
  double relative_rmse = std::numeric_limits<double>::infinity();  ///< before the first attempt

  [[nodiscard]] bool wanted() const { return relative_rmse <= wanted_relative_rmse; }
  [[nodiscard]] std::string text() const {
    return fmt::format("{}: relative RMSE {:.4f}{}", how, relative_rmse, wanted() ? "" : " (NOT REACHED)");
  }
};

/// Renders, and says how long the part took that a composite costs when its background is given.
using Render = std::function<StimulusLayers(double& seconds)>;

/// Says to standard error what was found: each attempt takes as long as all before it.
Reached attempt(const GivenBackground& given, std::string how, const Render& render) {
  Reached reached{.how = std::move(how)};
  const StimulusLayers layers = render(reached.seconds);
  const Stopwatch watch;
  static_cast<void>(compose(layers, Compositing::ratio, given.threads));
  reached.seconds += watch.seconds();
  reached.relative_rmse = given.relative_rmse(layers);
  fmt::print(stderr, "  {}, {:.2f} s\n", reached.text(), reached.seconds);
  return reached;
}

/// Sampled until its own estimate is low enough, by steps of a fifth. The joint pass makes the photograph and
/// the truth's part, which are given here: the composite's own cost is what the depth mesh is asked, and the
/// filter.
Reached reach_fast(const ConvergenceSubject& subject, const Geometry& depth, const GivenBackground& given) {
  Reached reached;
  for (double error = 0.03; error > given.least_error && !reached.wanted(); error /= 1.2)
    reached = attempt(given, fmt::format("fast, --error {:.4f}", error), [&](double& seconds) {
      const auto estimator = make_fast_estimator(
          subject.scene,
          {.error = error, .seed = subject.study.seed, .threads = subject.threads, .who_is_in_front = true});
      estimator->take_object(subject.stimulus.object_index, {});
      const Stopwatch watch;
      StimulusLayers layers = estimator->stimulus(subject.recipe, &depth, {}).layers;
      seconds = watch.seconds();
      return layers;
    });
  return reached;
}

Reached reach_path(const ConvergenceSubject& subject, const Geometry& depth, const GivenBackground& given) {
  Reached reached;
  for (int spp = given.first_spp; spp <= given.most_spp && !reached.wanted(); spp *= 2)
    reached = attempt(given, fmt::format("path, {} samples", spp), [&](double& seconds) {
      PathRun run = render_path(subject, subject.recipe, subject.geometry, depth,
                                subject.pass(spp, subject.study.seed));
      seconds = run.stimulus_seconds;
      return std::move(run.layers);
    });
  return reached;
}

}  // namespace

std::vector<Measurement> bench_picture(const BenchOptions& options) {
  ConvergenceRequest request{.only = "*-all-creature-0512", .threads = options.threads};
  if (options.quick) {
    request.width_px = 192;
    request.height_px = 108;
  }
  const ConvergenceSubject subject = load_subject(read_study(builtin_study("furnished_room")), request);
  // Capture again: the subject has its depth map already.
  const Stopwatch mesh_watch;
  const DepthMap map = capture_depth(subject.geometry.truth, subject.stimulus.condition.depth_width_px,
                                     subject.stimulus.condition.yaw_texels, subject.threads);
  const Geometry depth =
      subject_geometry(subject, subject_mesh(subject, map, subject.study.mesh, subject.study.mesh_tolerance));
  const double mesh_seconds = mesh_watch.seconds();
  fmt::print(stderr, "  the reference, by path\n");
  GivenBackground given =
      given_background(render_path(subject, subject.recipe, subject.geometry, depth,
                                   subject.pass(options.quick ? 16 : 64, subject.study.seed + 1000)));
  given.threads = subject.threads;
  if (options.quick) {
    given.first_spp = 2;
    given.most_spp = 8;
    given.least_error = 0.02;
  }
  const Reached fast = reach_fast(subject, depth, given), path = reach_path(subject, depth, given);
  return {{.what = "depth capture, mesh and hierarchy", .unit = "s", .found = mesh_seconds},
          {.what = fast.text(),
           .unit = "s",
           .found = fast.seconds,
           .beside = path.seconds,
           .ratio = fast.seconds / path.seconds},
          {.what = path.text(), .unit = "s", .found = path.seconds},
          {.what = "fast in all, at a relative RMSE of 0.034",
           .unit = "s",
           .found = mesh_seconds + fast.seconds,
           .beside = {},
           .ratio = {},
           .wanted = {Wanted::Kind::at_most, 3}}};
}

}  // namespace seamline
