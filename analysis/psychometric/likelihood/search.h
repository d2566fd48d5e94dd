#pragma once
#include <optional>
#include <vector>

#include "analysis/psychometric/likelihood/steps.h"

namespace seamline::analysis {

/// What was looked at to find the maximum; kept, because the profiles start from it.
struct Search {
  FitProblem problem;
  std::vector<double> places, log_scales, lapses, guesses;  ///< axes of the coarse grid
  std::vector<Maximum> cells;     ///< the grid, each cell at its likeliest lapse and guess
  std::optional<Maximum> smooth;  ///< best of the climbs
  std::optional<StepFit> step;    ///< none with a prior of the width, under which a step is impossible
  Maximum best;
  bool is_step = false;  ///< no sigmoid is likelier than the step (by 1e-6 log units)
};

/// The global maximum: a coarse grid over threshold, scale, lapse and guess; climbs from its best local
/// maxima, each also with the lapse rate pinned at either bound; and the exact likelihood of every step, so
/// that a step-like local optimum is never taken for the best fit nor the best fit missed because it is a
/// step.
[[nodiscard]] Search search_maximum(FitProblem problem);

/// The same for any number of levels: more than `most_unpooled_levels` (level_bins.h) are pooled into bins,
/// and pooled again in focus around what was found, until the bins there are far narrower than the scale or
/// are the levels themselves. Beta-binomial fits are not pooled: their rows count one by one.
[[nodiscard]] Search search_levels(FitProblem problem);

/// The maximum for nearly the same data (bootstrap, jackknife): one climb from `start`, and the steps.
[[nodiscard]] Maximum refit(const FitProblem& problem, const Maximum& start);

/// The same, with the step where that is the maximum.
struct Refit {
  Maximum maximum;
  std::optional<StepFit> step;
};
[[nodiscard]] Refit refit_with_step(const FitProblem& problem, const Maximum& start);

}  // namespace seamline::analysis
