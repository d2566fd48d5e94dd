#include "laboratory/convergence/convergence_samples.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>

#include "raytracer/common/stopwatch.h"
#include "renderer/estimators/estimator.h"
#include "stimuli/pictures/difference.h"

namespace seamline::renderer {
namespace {

constexpr int smallest_reference_spp = 128, largest_reference_spp = 16384;
constexpr int reference_to_largest_trial = 16;
constexpr int fewest_trials = 3;

/// What errors are measured against.
struct Reference {
  PathRun run;
  Image picture, off_object;
};

/// As many samples as the budget pays for, a power of 2: half for the reference, the rest for the trials,
/// whose sum is about as large. The price is that of a run long enough for a clock.
int affordable_spp(const ConvergenceSubject& subject, PathRuns& runs, double budget_s) {
  constexpr int longest_probe_spp = 64;
  double per_sample_s = 0;
  for (int spp = 2; spp <= longest_probe_spp; spp *= 2) {
    const double probe_s = runs.coupled(spp, subject.study.seed).seconds();
    per_sample_s = probe_s / spp;
    if (probe_s > 0.01 * budget_s) break;
  }
  const double affordable = 0.5 * budget_s / per_sample_s;
  if (!(affordable < largest_reference_spp)) return largest_reference_spp;
  return static_cast<int>(
      std::bit_floor(static_cast<unsigned>(std::max<double>(affordable, smallest_reference_spp))));
}

Reference render_reference_run(const ConvergenceSubject& subject, const Geometry& depth, int spp,
                               Progress& progress) {
  PassOptions options = subject.pass(spp, subject.study.seed + 2);
  // Truth pass and stimulus pass report a share each; together they are the reference's work.
  options.progress = [&, last = 0.0](double share) mutable {
    progress.advance((share < last ? share : share - last) * 0.5 * spp, "reference");
    last = share;
  };
  PathRun run = render_path(subject, subject.recipe, subject.geometry, depth, options);
  Image picture = compose(run.sums).picture;
  Image mask = off_object_mask(run);
  return {.run = std::move(run), .picture = std::move(picture), .off_object = std::move(mask)};
}

double noise_given(const Reference& reference, double exposure_ev) {
  const auto half = [&](std::size_t i) {
    return compose(onto_given_background(half_of(reference.run.sums, i), reference.run.sums)).picture;
  };
  return 0.5 * display_rmse(half(0), half(1), exposure_ev, &reference.off_object);
}

SeriesRow measure(const ConvergenceSubject& subject, const Series& series, int spp,
                  const Reference& reference) {
  const TimedRender render = series.render(spp);
  const Stopwatch watch;
  const Image picture = compose(render.sums).picture;
  const double seconds = render.seconds + watch.seconds();
  const Image given = compose(onto_given_background(render.sums, reference.run.sums)).picture;
  return {.series = series.name,
          .spp = spp,
          .seconds = seconds,
          .rays = render.rays,
          .rmse = display_rmse(picture, reference.picture, subject.exposure_ev()),
          .rmse_given = display_rmse(given, reference.picture, subject.exposure_ev(), &reference.off_object)};
}

/// A whole scene's joint pass is counted, although the other two objects' stimuli would share it in a set.
TimedRender render_fast(const ConvergenceSubject& subject, const Geometry& depth, int spp) {
  const Stopwatch watch;
  const std::unique_ptr<SceneEstimator> estimator =
      make_estimator(Estimator::fast, subject.scene,
                     {.spp = spp,
                      .seed = subject.study.seed,
                      .threads = subject.threads,
                      .who_is_in_front = subject.recipe.answers.occlusion == Who::depth});
  estimator->take_object(subject.stimulus.object_index, {});
  TimedRender render{.sums = estimator->stimulus(subject.recipe, &depth, {}).sums};
  render.seconds = watch.seconds();
  render.rays = estimator->truth().rays + render.sums.rays;
  return render;
}

/// Whether a rendering with twice the samples would take longer than the budget of one.
bool is_finished(const std::vector<SeriesRow>& rows, const Series& series, double longest_s) {
  const auto of_series = [&](const SeriesRow& row) { return row.series == series.name; };
  const auto last = std::find_if(rows.rbegin(), rows.rend(), of_series);
  return std::count_if(rows.begin(), rows.end(), of_series) >= fewest_trials &&
         2 * last->seconds > 1.1 * longest_s;
}

}  // namespace

std::vector<Series> sample_series(const ConvergenceSubject& subject, const Geometry& depth, PathRuns& runs) {
  const std::uint64_t seed = subject.study.seed, other_seed = seed + 1;
  return {
      {.name = "path coupled",
       .meaning = "with and without the object are one computation on shared paths",
       .render = [&runs, seed](int spp) -> TimedRender {
         const PathRun& run = runs.coupled(spp, seed);
         return {run.sums, run.seconds(), run.rays};
       }},
      {.name = "path same-seed",
       .meaning = "two renderings, with and without the object, that share their sample points: the same "
                  "picture as path coupled at the cost of both",
       .render = [&runs, seed](int spp) -> TimedRender {
         const PathRun& with = runs.coupled(spp, seed);
         const PathRun& without = runs.without(spp, seed);
         return {with.sums, with.seconds() + without.seconds(), with.rays + without.rays};
       }},
      {.name = "path independent",
       .meaning = "two renderings with different seeds",
       .render = [&runs, seed, other_seed](int spp) -> TimedRender {
         // The layers without the object come from a run that knows its coverage; the price is that of
         // one that does not know the object.
         const StimulusSums& sums_without = runs.coupled(spp, seed).sums;
         const PathRun& without = runs.without(spp, seed);
         const PathRun& with = runs.coupled(spp, other_seed);
         return {join_independent(sums_without, with.sums), with.seconds() + without.seconds(),
                 with.rays + without.rays};
       }},
      {.name = "fast",
       .meaning =
           "the scene's worlds in one joint pass, bounce light filtered; the scene's other two objects "
           "are rendered along",
       .render = [&subject, &depth](int spp) { return render_fast(subject, depth, spp); },
       .fewest_spp = 2},
  };
}

SampleResult measure_samples(const ConvergenceSubject& subject, double budget_s) {
  const Geometry depth = subject_geometry(
      subject,
      subject_mesh(subject, subject.map, subject.study.depth.mesh, subject.study.depth.mesh_tolerance));
  PathRuns runs(subject, depth);
  const int reference_spp = affordable_spp(subject, runs, budget_s);
  const int largest_spp = reference_spp / reference_to_largest_trial;
  constexpr double passes_a_trial = 3;  // coupled, another seed, without
  Progress progress(stimulus_id(subject.stimulus) + " samples",
                    reference_spp + 2 * passes_a_trial * largest_spp);
  const Reference reference = render_reference_run(subject, depth, reference_spp, progress);

  SampleResult result{.rows = {},
                      .meanings = {},
                      .reference_spp = reference_spp,
                      .reference_seconds = reference.run.seconds(),
                      .reference_noise = estimated_noise(reference.run.sums, subject.exposure_ev()).value(),
                      .reference_noise_given = noise_given(reference, subject.exposure_ev())};
  const double longest_s = reference.run.seconds() / reference_to_largest_trial;
  std::vector<Series> open = sample_series(subject, depth, runs);
  for (const Series& series : open) result.meanings.emplace_back(series.name, series.meaning);
  for (int spp = 1; !open.empty() && spp <= reference_spp; spp *= 2) {
    for (const Series& series : open) {
      if (spp >= series.fewest_spp) result.rows.push_back(measure(subject, series, spp, reference));
      progress.advance(passes_a_trial * spp / result.meanings.size(), series.name);
    }
    std::erase_if(open, [&](const Series& series) { return is_finished(result.rows, series, longest_s); });
  }
  return result;
}

}  // namespace seamline::renderer
