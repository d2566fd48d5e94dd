#pragma once
#include "analysis/psychometric/likelihood/profile.h"
#include "analysis/psychometric/likelihood/psychometric_fit.h"

namespace seamline::analysis {

/// Profile-likelihood intervals of a fit, in the user's units. An infinite end is open: no value on that side
/// is excluded. Everything is open when there are fewer than two levels. `cut` is the drop in 2 ln L that
/// is allowed: the quantile of chi-squared with one degree of freedom, 95 % unless told.
[[nodiscard]] Interval threshold_interval(const PsychometricFit& fit, double cut = chi_squared_95);
/// On the axis (octaves on log2). The low end is 0 when a step is not excluded.
[[nodiscard]] Interval width_interval(const PsychometricFit& fit, double cut = chi_squared_95);
/// Both ends are the value when the rate is fixed, and within its bounds when it is free.
[[nodiscard]] Interval lapse_interval(const PsychometricFit& fit, double cut = chi_squared_95);
[[nodiscard]] Interval guess_interval(const PsychometricFit& fit, double cut = chi_squared_95);

/// A level and its interval; the estimate is none when the function never has the probability.
struct LevelEstimate {
  std::optional<double> estimate;
  Interval ci95;
};

/// The level where a share `correct` (0 to 1) of the answers is right.
[[nodiscard]] LevelEstimate level_of_correct(const PsychometricFit& fit, double correct,
                                             double cut = chi_squared_95);
/// The level where F, before guess and lapse, is `share` (0 to 1); 0.5 is the threshold, 1 - 1/e the textbook
/// position of a Gumbel or Weibull function.
[[nodiscard]] LevelEstimate level_of_share(const PsychometricFit& fit, double share,
                                           double cut = chi_squared_95);

}  // namespace seamline::analysis
