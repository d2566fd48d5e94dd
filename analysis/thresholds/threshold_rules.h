#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/thresholds/thresholds.h"

namespace seamline::analysis {

// What the thresholds of record are. The computation (thresholds.cpp), the methods text, thresholds.json and
// a preregistration are all written from this table, so that what was promised is what is computed.

enum class Estimator { isotonic, logistic };
enum class IntervalMethod {
  score_test,          ///< inverted (`level_interval`, `logistic_level_interval`)
  expanded_percentile  ///< bootstrap over participants (`percentile_interval` at `expanded_levels`)
};

struct ThresholdRule {
  const char* name;             ///< "PT"
  std::optional<double> level;  ///< of mean noticeability; none: the centre of the logistic
  Estimator estimator;          ///< of record; what other estimators say stands beside
  IntervalMethod interval;
  ThresholdEstimate CurveThresholds::*estimate;
};

inline constexpr std::array<ThresholdRule, 3> threshold_rules = {
    {{"PT", perceptual_level, Estimator::isotonic, IntervalMethod::score_test, &CurveThresholds::perceptual},
     {"SN", slight_level, Estimator::isotonic, IntervalMethod::score_test,
      &CurveThresholds::slightly_noticeable},
     {"IP", std::nullopt, Estimator::logistic, IntervalMethod::expanded_percentile,
      &CurveThresholds::inflection}}};

/// Each rule as a sentence; then when there is an estimate, and what holds for several thresholds.
[[nodiscard]] std::vector<std::string> sentences_of_rules();

/// "95 %: PT and SN by an inverted score test, IP by the expanded percentile bootstrap over participants".
[[nodiscard]] std::string intervals_in_short();

/// "PT and SN": the thresholds whose interval is made so.
[[nodiscard]] std::string names_with(IntervalMethod method);

}  // namespace seamline::analysis
