#pragma once
#include <functional>
#include <string>
#include <vector>

#include "analysis/psychometric/intervals/judged_fit.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/stability_case.h"

namespace seamline::stability {

/// Counts at some levels, `trials` each, right with the share that is given, rounded.
[[nodiscard]] std::vector<LevelCounts> counts_at(const std::vector<double>& levels, std::int64_t trials,
                                                 const std::function<double(double level)>& share);
/// The same at the seven widths of the paper, 64 to 4096 px.
[[nodiscard]] std::vector<LevelCounts> counts_at_widths(std::int64_t trials,
                                                        const std::function<double(double width_px)>& share);
/// Three alternatives, performance that falls with width.
[[nodiscard]] FitOptions falling_choice_of_three();
/// The function that is planted in data: threshold 500 px.
[[nodiscard]] PsychometricFunction planted_function(double lapse);

/// How counts become a fit with verdict; the product's is `judge_fit`.
using FitRule = std::function<JudgedFit(const std::vector<LevelCounts>& counts, const FitOptions& options,
                                        const FitRequest& request)>;

/// A fit must come to a verdict. Counts: another verdict, an interval without the values that it must hold, a
/// range that is not the interval, a closed interval without an estimate inside, a number that is none.
struct WantedVerdict {
  std::vector<LevelCounts> counts;
  FitOptions options = falling_choice_of_three();
  std::string text;         ///< how the verdict begins
  Interval must_hold = {};  ///< finite ends: the threshold's interval must hold them
  bool open_high = false;   ///< the interval's upper end must be open
};
[[nodiscard]] Finding try_verdict(const WantedVerdict& wanted, const FitRule& fit = judge_fit);

/// A million trials a level, exactly as expected: relative error of the threshold.
[[nodiscard]] Finding try_million_trials();
/// Levels from 1e-6 to 1e6 under three sigmoids: largest relative error of threshold and scale.
[[nodiscard]] Finding try_wide_levels();
/// A lapse rate of 0.2 with a cap of 0.1 (must be at the cap, and said) and of 0.5: error of the lapse rate.
[[nodiscard]] Finding try_large_lapse();
/// Answers that go up and down with level: the fit must be called a misfit. The p of its deviance.
[[nodiscard]] Finding try_not_monotone();

}  // namespace seamline::stability
