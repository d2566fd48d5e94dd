#include "laboratory/convergence/convergence_runs.h"
#include "raytracer/common/stopwatch.h"

namespace seamline::renderer {
namespace {

using Pixels = std::vector<StimulusPixel>;

StimulusPixel sum_of(const StimulusSums& sums, std::size_t pixel) {
  StimulusPixel sum = sums.halves[0][pixel];
  return sum += sums.halves[1][pixel];
}

}  // namespace

PathRun render_path(const ConvergenceSubject& subject, const Recipe& recipe, const ObjectGeometry& geometry,
                    const Geometry& depth, const PassOptions& options) {
  PathRun run;
  const Stopwatch truth_watch;
  const TruthSums truth = render_truth(subject.scene, geometry, options);
  run.truth_seconds = truth_watch.seconds();
  const Stopwatch stimulus_watch;
  run.sums = render_stimulus(subject.scene, geometry, &depth, truth, recipe, options);
  run.stimulus_seconds = stimulus_watch.seconds();
  run.rays = truth.rays + run.sums.rays;
  run.reference = reference_image(truth);
  run.matte = matte_image(truth);
  return run;
}

ObjectGeometry without_object(const ConvergenceSubject& subject) {
  return {subject.scene.geometry_without(subject.stimulus.object_index), subject.scene.geometry(false, {})};
}

PathRuns::PathRuns(const ConvergenceSubject& subject, const Geometry& depth)
    : subject_(subject), depth_(depth), no_object_(without_object(subject)) {}

const PathRun& PathRuns::coupled(int spp, std::uint64_t seed) {
  return find_or_render(subject_.geometry, spp, seed);
}

const PathRun& PathRuns::without(int spp, std::uint64_t seed) {
  return find_or_render(no_object_, spp, seed);
}

const PathRun& PathRuns::find_or_render(const ObjectGeometry& geometry, int spp, std::uint64_t seed) {
  if (spp != spp_) runs_.clear();
  spp_ = spp;
  const auto key = std::make_pair(&geometry, seed);
  const auto found = runs_.find(key);
  if (found != runs_.end()) return found->second;
  return runs_
      .emplace(key, render_path(subject_, subject_.recipe, geometry, depth_, subject_.pass(spp, seed)))
      .first->second;
}

StimulusSums join_independent(const StimulusSums& without, const StimulusSums& with) {
  StimulusSums joined = with;
  joined.halves[1].assign(joined.halves[1].size(), {});
  Pixels& pixels = joined.halves[0];
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i] = sum_of(with, i);
    const StimulusPixel other = sum_of(without, i);
    // Where one of the two sees nothing to divide, the pixel is the second rendering's own.
    if (!(other.uncovered_surfaces > 0) || !(pixels[i].uncovered_surfaces > 0)) continue;
    const float factor =
        static_cast<float>(pixels[i].uncovered_surfaces) / static_cast<float>(other.uncovered_surfaces);
    pixels[i].without_object = other.without_object * factor;
    pixels[i].background = other.background * factor;
  }
  return joined;
}

StimulusSums onto_given_background(const StimulusSums& sums, const StimulusSums& photograph) {
  StimulusSums given = sums;
  for (std::size_t i = 0; i < photograph.halves[0].size(); ++i) {
    const StimulusPixel known = sum_of(photograph, i);
    if (!(known.uncovered_surfaces > 0)) continue;
    const Rgb mean = known.background / static_cast<float>(known.uncovered_surfaces);
    for (Pixels& half : given.halves)
      half[i].background = mean * static_cast<float>(half[i].uncovered_surfaces);
  }
  return given;
}

StimulusSums half_of(const StimulusSums& sums, std::size_t half) {
  StimulusSums out = sums;
  out.spp = (sums.spp + 1 - static_cast<int>(half)) / 2;
  out.halves[0] = sums.halves[half];
  out.halves[1].assign(out.halves[1].size(), {});
  out.light_as_sampled[0] = sums.light_as_sampled[half];
  out.light_as_sampled[1].assign(out.light_as_sampled[1].size(), 0.0F);
  return out;
}

Image off_object_mask(const PathRun& run) {
  Image mask(run.matte.width_px, run.matte.height_px, 1);
  for (std::size_t i = 0; i < mask.values.size(); ++i) {
    const bool covered = run.matte.values[i] > 0.0F || (sum_of(run.sums, i).object > 0.0F).any();
    mask.values[i] = covered ? 0.0F : 1.0F;
  }
  return mask;
}

}  // namespace seamline::renderer
