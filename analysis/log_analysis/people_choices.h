#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/psychometric/intervals/verdict.h"
#include "analysis/psychometric/likelihood/fit_options.h"

namespace seamline::analysis {

/// The threshold of one participant on one curve, from that participant's answers alone.
struct OwnThreshold {
  std::string participant;
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  int answers = 0;
  double right_share = 0;           ///< of them
  std::optional<double> threshold;  ///< level where half is seen; exactly where the interval is closed
  Interval ci95;                    ///< profile likelihood, over this participant's answers
  Verdict verdict;
};

/// How a function of right choices is fitted: cumulative normal along the axis, guess rate the task's
/// (ScoreMatrix::guess_rate), lapse free to 0.1, in the direction of the log.
[[nodiscard]] FitOptions options_of_choices(const Analysis& analysis);

/// Of every participant used, in the order of the curves, where the study's task repeats its stimuli or
/// places them by the answers: a function of the same form as `choice_curves`. Empty otherwise, since a
/// participant who sees each stimulus once says too little.
[[nodiscard]] std::vector<OwnThreshold> own_thresholds(const Analysis& analysis);

}  // namespace seamline::analysis
