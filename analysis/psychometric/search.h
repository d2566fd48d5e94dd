#pragma once
#include <optional>
#include <vector>

#include "analysis/psychometric/maximise.h"
#include "stimuli/support/numbers.h"

namespace seamline::analysis {

/// The likeliest function in the limit of scale 0: guess on one side, 1 - lapse on the other. Every threshold
/// strictly between `low_t` and `high_t` gives the same likelihood (infinite: beyond the tested levels). When
/// the step goes through a level, whose performance lies between, these are its neighbours.
struct StepFit {
  Maximum maximum;  ///< a function so steep that it is the step at every tested level
  double low_t = -infinity;
  double high_t = infinity;
  bool through_level = false;
};

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

/// The maximum for nearly the same data (bootstrap, jackknife): one climb from `start`, and the steps.
[[nodiscard]] Maximum refit(const FitProblem& problem, const Maximum& start);

/// The likeliest step; none when every step is impossible.
[[nodiscard]] std::optional<StepFit> likeliest_step(const FitProblem& problem);

}  // namespace seamline::analysis
