// One composite at a wanted error: fast beside path, the background given.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "laboratory/bench/bench.h"
#include "laboratory/convergence/convergence_runs.h"
#include "raytracer/common/sampler.h"
#include "raytracer/common/stopwatch.h"
#include "raytracer/error/true_error.h"
#include "renderer/estimators/fast/fast_stimulus.h"
#include "renderer/estimators/fast/fast_truth_pass.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/assets.h"

namespace seamline::renderer {
namespace {

constexpr double wanted_relative_rmse = 0.034;  // of the background's mean radiance

/// What pictures are measured against, and where.
struct GivenBackground {
  StimulusSums sums;                   ///< of the reference; its background is the one given
  ReferenceHalves halves;              ///< the composite from each half of the samples, on that background
  Image mask;                          ///< lit pixels off the object
  int first_spp = 16, most_spp = 256;  ///< where looking for the wanted error begins and ends
  double least_error = 0.01;           ///< likewise of `fast`, as a share of the mean radiance
  int threads = 1;
  std::function<void(const std::string&)> said = {};
  double mean_radiance = 0;  ///< of the background there

  [[nodiscard]] Rgb radiance(std::size_t pixel) const {
    const StimulusPixel &a = sums.halves[0][pixel], &b = sums.halves[1][pixel];
    return a.uncovered_surfaces + b.uncovered_surfaces > 0
               ? Rgb((a.background + b.background) / (a.uncovered_surfaces + b.uncovered_surfaces))
               : Rgb::Zero();
  }
  [[nodiscard]] double relative_rmse(const StimulusSums& trial) const {
    const Image picture = compose(onto_given_background(trial, sums)).picture;
    return true_linear_error(picture, halves, mask).rmse() / mean_radiance;
  }
};

/// Lit: the photograph's surface has at least a hundredth of the mean radiance. Sky is never part: nothing is
/// computed there.
GivenBackground given_background(PathRun reference) {
  GivenBackground given;
  given.mask = off_object_mask(reference);
  given.sums = std::move(reference.sums);
  const auto mean = [&] {
    double sum = 0, pixels = 0;
    for (std::size_t i = 0; i < given.mask.values.size(); ++i)
      if (given.mask.values[i] > 0.5F && given.radiance(i).mean() > 0) {
        sum += given.radiance(i).mean();
        ++pixels;
      }
    return pixels > 0 ? sum / pixels : 0;
  };
  const double lit = 0.01 * mean();
  for (std::size_t i = 0; i < given.mask.values.size(); ++i)
    if (given.radiance(i).mean() <= lit) given.mask.values[i] = 0;
  given.mean_radiance = mean();
  for (std::size_t half = 0; half < 2; ++half)
    given.halves[half] = compose(onto_given_background(half_of(given.sums, half), given.sums)).picture;
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
using Render = std::function<StimulusSums(double& seconds)>;

/// Says what was found: each attempt takes as long as all before it.
Reached attempt(const GivenBackground& given, std::string how, const Render& render) {
  Reached reached{.how = std::move(how)};
  const StimulusSums sums = render(reached.seconds);
  const Stopwatch watch;
  static_cast<void>(compose(sums, Compositing::ratio, given.threads));
  reached.seconds += watch.seconds();
  reached.relative_rmse = given.relative_rmse(sums);
  given.said(fmt::format("{}, {:.2f} s", reached.text(), reached.seconds));
  return reached;
}

/// What a composite onto a given photograph begins with. Who covers what comes from a few samples of the
/// truth; their light is replaced by the photograph's, which is without error.
struct GivenTruth {
  /// Display units shrink to nothing where the sRGB curve begins, and there it is a straight line: what is
  /// sampled for in them is linear radiance.
  static constexpr double dark_exposure_ev = -12;
  static constexpr double display_per_radiance = 12.92 / 4096;  // at that exposure

  static TruthScene lit(TruthScene scene) {
    scene.light.sky_rays = 2;
    scene.definition.exposure_ev = dark_exposure_ev;
    return scene;
  }

  GivenTruth(const ConvergenceSubject& subject, const GivenBackground& given)
      : scene(lit(subject.scene)), scene_sums(empty_sums(scene.camera)) {
    constexpr int spp = 4;
    add_samples(scene, SceneGeometry(scene), std::vector<int>(scene_sums.spp.size(), spp),
                {.seed = subject.study.seed,
                 .threads = subject.threads,
                 .who_is_in_front = subject.recipe.answers.occlusion == Who::depth},
                scene_sums);
    truth = truth_sums(scene_sums, scene.camera, scene.light, subject.stimulus.object_index,
                       {.filter = {}, .threads = subject.threads});
    for (auto& half : truth.halves)
      for (std::size_t i = 0; i < half.size(); ++i)
        half[i].without_object = {given.radiance(i) * half[i].uncovered_surfaces, Rgb::Zero()};
    no_error.tiles.resize(scene_sums.grid.count());
    no_error.blocks.resize(scene_sums.blocks().count());
  }

  TruthScene scene;
  SceneSums scene_sums;
  TruthSums truth;
  ErrorEstimate no_error;
};

/// Sampled until its own estimate, over object and all, is low enough, by steps of a tenth. So much error
/// lets the filter reach far.
Reached reach_fast(const ConvergenceSubject& subject, const Geometry& depth, const GivenBackground& given) {
  const GivenTruth begin(subject, given);
  const ObjectTruth truth{begin.scene, begin.scene_sums, subject.geometry, subject.stimulus.object_index,
                          begin.truth, begin.no_error};
  Reached reached;
  for (double error = 0.05; error > given.least_error && !reached.wanted(); error /= 1.1)
    reached = attempt(given, fmt::format("fast, estimated error {:.3f}", error), [&](double& seconds) {
      const double display = error * given.mean_radiance * GivenTruth::display_per_radiance;
      const FastStimulusOptions options{.seed = subject.study.seed,
                                        .threads = subject.threads,
                                        .target = ErrorTarget{std::sqrt(display * display + rounding_square)},
                                        .filter = {2, 2.0F}};
      EstimatorChoices choices =
          estimator_choices(Estimator::fast, light_facts(begin.scene), GivenTruth::dark_exposure_ev,
                            {.error = options.target->rmse});
      choices.ratio_filter = {4, 1.0F};
      const Stopwatch watch;
      StimulusSums sums = render_fast_stimulus(truth, &depth, subject.recipe, choices, options).sums;
      seconds = watch.seconds();
      return sums;
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
      return std::move(run.sums);
    });
  return reached;
}

}  // namespace

std::vector<BenchLine> bench_picture(const BenchOptions& options) {
  ConvergenceRequest request{.only = "*-all-creature-0512", .threads = options.threads};
  if (options.quick) {
    request.width_px = 192;
    request.height_px = 108;
  }
  const ConvergenceSubject subject = load_subject(read_study(builtin_study("furnished_room")), request);
  // Capture again: the subject has its depth map already.
  const Stopwatch mesh_watch;
  const DepthMap map = capture_depth(subject.geometry.truth, subject.stimulus.depth.width_px,
                                     subject.stimulus.depth.yaw_texels, subject.threads);
  // The rays of one picture do not pay for a better tree.
  const Geometry depth(
      subject_mesh(subject, map, subject.study.depth.mesh, subject.study.depth.mesh_tolerance),
      Rgb::Constant(static_cast<float>(subject.scene.definition.albedo)), TreeQuality::for_few_rays);
  const double mesh_seconds = mesh_watch.seconds();
  options.said("the reference, by path");
  GivenBackground given = given_background(
      render_path(subject, subject.recipe, subject.geometry, depth,
                  subject.pass(options.quick ? 16 : 64, subject.study.seed + reference_seed_offset)));
  given.threads = subject.threads;
  given.said = options.said;
  if (options.quick) {
    given.first_spp = 2;
    given.most_spp = 8;
    given.least_error = 0.05;
  }
  const Reached fast = reach_fast(subject, depth, given), path = reach_path(subject, depth, given);
  return {{.what = "depth capture, mesh and hierarchy", .unit = "s", .found = mesh_seconds},
          {.what = fast.text(),
           .unit = "s",
           .found = fast.seconds,
           .beside = path.seconds,
           .ratio = fast.seconds / path.seconds},
          {.what = path.text(), .unit = "s", .found = path.seconds},
          {.what = fast.wanted() ? "fast in all, at a relative RMSE of 0.034" : "fast in all",
           .unit = "s",
           .found = mesh_seconds + fast.seconds,
           .beside = {},
           .ratio = {},
           .wanted = fast.wanted() ? Wanted{Wanted::Kind::at_most, 3} : Wanted{}}};
}

}  // namespace seamline::renderer
