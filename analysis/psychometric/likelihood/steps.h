#pragma once
#include <array>
#include <optional>
#include <vector>

#include "analysis/psychometric/likelihood/maximise.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

/// A function in the limit of scale 0: guess on one side, 1 - lapse on the other. Between two levels every
/// threshold gives the same likelihood. Through a level, whose performance lies between, the threshold goes
/// to that level as the scale goes to 0, along the ridge on which the level keeps its own performance:
/// m = x - sign s z. The ridge is as likely up to a scale at which its neighbours notice.
struct StepFit {
  Maximum maximum;  ///< a function so steep that it is the step at every tested level
  bool through_level = false;
  /// The thresholds that are as likely (within 0.01 log units): between the two levels around the step, or
  /// between a level and the end of its ridge. Infinite: beyond the tested levels.
  double low_t = -infinity;
  double high_t = infinity;
  double largest_log_scale = 0;     ///< of the least steep function that is as likely
  Theta middle;                     ///< the function in the middle of all those
  double level_t = 0, level_z = 0;  ///< of a step through a level: its place and F^-1 of its performance
  /// Quantiles, evenly spaced from 0 to 1, of the scale on a level's ridge, weighted by the likelihood that
  /// it leaves the neighbours: nothing else is known of it.
  std::array<double, 17> ridge_scales{};
};

/// A function on the ridge of a step through a level, of all that lie there the one at a share (0 to 1);
/// 0 is the step itself.
[[nodiscard]] Theta on_ridge(const FitProblem& problem, const StepFit& step, double share);

/// The likeliest step, if its objective is at least `needed`; none with a prior of the width.
[[nodiscard]] std::optional<StepFit> likeliest_step(const FitProblem& problem, double needed = -infinity);

/// For every level and every gap its step, at its likeliest lapse and guess rate, if its objective is at
/// least `needed`; at most `most` of them, the likeliest first. Those through a level may have its
/// performance on the other side of the threshold forbidden by the neighbours; they are tops of ridges.
[[nodiscard]] std::vector<StepFit> likely_steps(const FitProblem& problem, double needed, std::size_t most);

}  // namespace seamline::analysis
