// One composite at a wanted error: fast beside path, the background given.
#include <fmt/format.h>

#include "renderer/bench.h"
#include "renderer/convergence_runs.h"
#include "renderer/estimator.h"
#include "renderer/true_error.h"
#include "stimuli/study_file.h"
#include "stimuli/support/assets.h"

namespace seamline {
namespace {

constexpr double wanted_relative_rmse = 0.034;  // of the background's mean radiance

/// What pictures are measured against, and where.
struct GivenBackground {
  StimulusLayers layers;     ///< of the reference; its background is the one given
  ReferenceHalves halves;    ///< the composite from each half of the samples, on that background
  Image mask;                ///< lit pixels off the object
  int most_spp = 256;        ///< where looking for the wanted error ends
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

/// The smallest power of 2 of samples a pixel that reaches the wanted error, and what the composite took.
struct Reached {
  int spp = 0;
  double seconds = 0;
  double relative_rmse = 0;
};
using Render = std::function<StimulusLayers(int spp, double& seconds)>;

Reached reach(const GivenBackground& given, int fewest_spp, const Render& render) {
  Reached reached;
  for (int spp = fewest_spp; spp <= given.most_spp; spp *= 2) {
    reached.spp = spp;
    const StimulusLayers layers = render(spp, reached.seconds);
    const Stopwatch watch;
    static_cast<void>(compose(layers));
    reached.seconds += watch.seconds();
    reached.relative_rmse = given.relative_rmse(layers);
    if (reached.relative_rmse <= wanted_relative_rmse) break;
  }
  return reached;
}

/// The joint pass makes the photograph and the truth's part, which are given here: the composite's own cost
/// is what the depth mesh is asked, and the filter.
Reached reach_fast(const ConvergenceSubject& subject, const Geometry& depth, const GivenBackground& given) {
  return reach(given, 2, [&](int spp, double& seconds) {
    const auto estimator = make_fast_estimator(
        subject.scene,
        {.spp = spp, .seed = subject.study.seed, .threads = subject.threads, .who_is_in_front = true});
    estimator->take_object(subject.stimulus.object_index, {});
    const Stopwatch watch;
    StimulusLayers layers = estimator->stimulus(subject.recipe, &depth, {}).layers;
    seconds = watch.seconds();
    return layers;
  });
}

Reached reach_path(const ConvergenceSubject& subject, const Geometry& depth, const GivenBackground& given) {
  return reach(given, 1, [&](int spp, double& seconds) {
    PathRun run =
        render_path(subject, subject.recipe, subject.geometry, depth, subject.pass(spp, subject.study.seed));
    seconds = run.stimulus_seconds;
    return std::move(run.layers);
  });
}

std::string reached_text(const char* estimator, const Reached& reached) {
  return fmt::format("{}, {} samples: relative RMSE {:.4f}{}", estimator, reached.spp, reached.relative_rmse,
                     reached.relative_rmse <= wanted_relative_rmse ? "" : " (NOT REACHED)");
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
  GivenBackground given =
      given_background(render_path(subject, subject.recipe, subject.geometry, depth,
                                   subject.pass(options.quick ? 16 : 128, subject.study.seed + 1000)));
  if (options.quick) given.most_spp = 8;
  const Reached fast = reach_fast(subject, depth, given), path = reach_path(subject, depth, given);
  return {{.what = "depth capture, mesh and hierarchy", .unit = "s", .found = mesh_seconds},
          {.what = reached_text("fast", fast),
           .unit = "s",
           .found = fast.seconds,
           .beside = path.seconds,
           .ratio = fast.seconds / path.seconds},
          {.what = reached_text("path", path), .unit = "s", .found = path.seconds},
          {.what = "fast in all, at a relative RMSE of 0.034",
           .unit = "s",
           .found = mesh_seconds + fast.seconds,
           .beside = {},
           .ratio = {},
           .wanted = {Wanted::Kind::at_most, 3}}};
}

}  // namespace seamline
