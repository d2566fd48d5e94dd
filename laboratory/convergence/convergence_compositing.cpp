#include "laboratory/convergence/convergence_compositing.h"

#include <bit>
#include <numbers>

#include "stimuli/pictures/difference.h"
#include "support/running/progress.h"

namespace seamline::renderer {
namespace {

constexpr int largest_spp = 64;
constexpr int photograph_to_trial = 4;  // samples of the photograph for one of a trial

/// The runs of the four seeds that two independent compositings need, and the photograph they are put on.
struct Runs {
  std::vector<PathRun> seeds;
  PathRun photograph;
  double without_seconds = 0;  ///< of the rendering without the object
  Image off_object;
};

/// Everything from the depth mesh, as the paper composites.
Recipe paper_recipe(const ConvergenceSubject& subject) {
  return recipe(Artifact::all, subject.study.isolation);
}

int affordable_spp(const ConvergenceSubject& subject, const Geometry& depth, double budget_s) {
  const double probe_s = render_path(subject, paper_recipe(subject), subject.geometry, depth,
                                     subject.pass(1, subject.study.seed))
                             .seconds();
  const double runs = 4 + 1 + photograph_to_trial;
  const double affordable = std::clamp<double>(budget_s / (runs * probe_s), 2, largest_spp);
  return static_cast<int>(std::bit_floor(static_cast<unsigned>(affordable)));
}

Runs render_runs(const ConvergenceSubject& subject, const Geometry& depth, int spp, Progress& progress) {
  const auto render = [&](const ObjectGeometry& geometry, int samples, std::uint64_t seed) {
    PathRun run = render_path(subject, paper_recipe(subject), geometry, depth, subject.pass(samples, seed));
    progress.advance(samples, "renderings of the local scene");
    return run;
  };
  Runs runs;
  const std::uint64_t seed = subject.study.seed;
  for (std::uint64_t i = 0; i < 4; ++i) runs.seeds.push_back(render(subject.geometry, spp, seed + i));
  runs.photograph = render(subject.geometry, photograph_to_trial * spp, seed + 4);
  runs.off_object = off_object_mask(runs.photograph);
  runs.without_seconds = render(without_object(subject), spp, seed).stimulus_seconds;
  return runs;
}

/// Shares of the pixels off the object that a display cannot show.
void count_clipped(const Image& picture, const Image& off_object, double exposure_ev, CompositingRow& row) {
  const float white = static_cast<float>(std::exp2(-exposure_ev));
  std::size_t pixels = 0, below = 0, above = 0;
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) {
      if (off_object.at(x, y) <= 0.5F) continue;
      ++pixels;
      below += (picture.rgb(x, y) < 0.0F).any() ? 1 : 0;
      above += (picture.rgb(x, y) > white).any() ? 1 : 0;
    }
  if (pixels == 0) return;
  row.below_black = static_cast<double>(below) / static_cast<double>(pixels);
  row.above_white = static_cast<double>(above) / static_cast<double>(pixels);
}

CompositingRow compare(const ConvergenceSubject& subject, const Runs& runs, Compositing compositing,
                       bool independent) {
  const auto picture = [&](std::size_t no, std::size_t with) {
    const StimulusSums sums =
        independent ? join_independent(runs.seeds[no].sums, runs.seeds[with].sums) : runs.seeds[with].sums;
    return compose(onto_given_background(sums, runs.photograph.sums), compositing).picture;
  };
  const double exposure_ev = subject.exposure_ev();
  const Image one = picture(0, 1), another = picture(2, 3);
  CompositingRow row{.compositing = compositing,
                     .renders = independent ? "independent" : "coupled",
                     .spp = runs.seeds[0].sums.spp,
                     .seconds = runs.seeds[1].stimulus_seconds + (independent ? runs.without_seconds : 0)};
  row.noise = display_rmse(one, another, exposure_ev, &runs.off_object) / std::numbers::sqrt2;
  row.rmse = display_rmse(one, runs.photograph.reference, exposure_ev, &runs.off_object);
  count_clipped(one, runs.off_object, exposure_ev, row);
  return row;
}

}  // namespace

CompositingResult measure_compositing(const ConvergenceSubject& subject, double budget_s) {
  const Geometry depth = subject_geometry(
      subject,
      subject_mesh(subject, subject.map, subject.study.depth.mesh, subject.study.depth.mesh_tolerance));
  const int spp = affordable_spp(subject, depth, budget_s);
  Progress progress(stimulus_id(subject.stimulus) + " compositing", spp * (5.0 + photograph_to_trial));
  const Runs runs = render_runs(subject, depth, spp, progress);
  CompositingResult result;
  for (const bool independent : {false, true})
    for (const Compositing compositing : {Compositing::ratio, Compositing::additive})
      result.rows.push_back(compare(subject, runs, compositing, independent));
  CompositingRow reference;
  count_clipped(runs.photograph.reference, runs.off_object, subject.exposure_ev(), reference);
  result.reference_above_white = reference.above_white;
  return result;
}

}  // namespace seamline::renderer
