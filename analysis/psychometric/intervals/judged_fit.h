#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/intervals/bootstrap_intervals.h"
#include "analysis/psychometric/intervals/fit_intervals.h"
#include "analysis/psychometric/intervals/verdict.h"

namespace seamline::analysis {

/// What `seamline fit` computes beside the fit.
struct FitRequest {
  std::vector<double> percents = {};  ///< levels of these percentages correct (0 to 100)
  bool answers_are_yes = false;       ///< "yes" in place of "correct", in texts
  int bootstrap_replicates = 0;       ///< 0: no bootstrap intervals
  int deviance_replicates = 1000;     ///< 0: no p of the deviance
  std::uint64_t seed = 1;
  std::string unit = {};  ///< of the levels, for texts
  /// Told what is under way, with the share (0 to 1) of the work that is done.
  std::function<void(double share, const std::string& now_doing)> progress = {};
};

struct PercentLevel {
  double percent = 0;
  LevelEstimate level;      ///< an estimate exactly when the interval is closed
  bool is_reached = false;  ///< between the guess and the lapse rate of the fit
  std::optional<Interval> bootstrap_ci95;
};

/// A fit with all that is said about it.
struct JudgedFit {
  PsychometricFit fit;
  FitRequest request;
  std::optional<double> threshold;  ///< exactly when `threshold_ci95` is closed
  Interval threshold_ci95, width_ci95, lapse_ci95, guess_ci95;
  OverdispersionEstimate overdispersion;
  Goodness goodness;
  double deviance_p = 0;  ///< NaN: not tested
  std::vector<PercentLevel> percents;
  /// Open where the profile intervals are: what the likelihood does not exclude no replicate excludes.
  std::optional<BootstrapIntervals> bootstrap;
  Verdict verdict;
  std::vector<std::string> warnings;
};

/// Fits and computes everything asked for. Throws InputError as `fit_psychometric` does, and when a
/// percentage is not between 0 and 100.
[[nodiscard]] JudgedFit judge_fit(const std::vector<LevelCounts>& counts, const FitOptions& options,
                                  const FitRequest& request);

}  // namespace seamline::analysis
