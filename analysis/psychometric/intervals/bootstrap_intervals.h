#pragma once
#include <cstdint>
#include <optional>

#include "analysis/psychometric/likelihood/profile.h"
#include "analysis/psychometric/likelihood/psychometric_fit.h"

namespace seamline::analysis {

struct BootstrapRequest {
  int replicates = 2000;
  std::uint64_t seed = 1;
  std::optional<double> correct = std::nullopt;  ///< share right (0 to 1) whose level is wanted too
};

/// 95 % intervals, in the user's units; open where the quantile falls among replicates without a finite
/// value.
struct BootstrapIntervals {
  Interval threshold, width, lapse;
  std::optional<Interval> level_of_correct;
  int replicates = 0;
  int without_threshold = 0;  ///< replicates whose threshold ran to the edge of the search
  int steps = 0;              ///< replicates that were a step: width 0
};

/// Parametric bootstrap: counts simulated from the fit are fitted again; bias-corrected and accelerated (BCa,
/// Efron 1987) with the acceleration from leaving out one answer at a time. A replicate that is a step has no
/// single threshold: it stands for all that are as likely (`StepFit`), evenly, so that an end may fall
/// anywhere between two levels and not only at them. An interval holds what the fit itself makes as likely.
/// The same bits for the same seed. Everything is open with fewer than two levels.
[[nodiscard]] BootstrapIntervals bootstrap_intervals(const PsychometricFit& fit,
                                                     const BootstrapRequest& request);

}  // namespace seamline::analysis
