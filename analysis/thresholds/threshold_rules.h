#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/thresholds/thresholds.h"

namespace seamline::analysis {

// What the thresholds are: those of record, and beside them the paper's own way. The computation
// (thresholds.cpp), report, methods text, thresholds.json, CSV and a preregistration are all written from
// these tables, so that what was promised is what is computed.

enum class CurveEstimator {
  joint,     ///< the joint model of seeing, guessing and rating (documentation/explanation/joint_model.md)
  isotonic,  ///< straight lines between the means of the tested levels, non-increasing
  logistic   ///< four parameters, least squares through the means
};
enum class IntervalMethod {
  jackknife_test,      ///< levels not told from the one sought, with the jackknife's variance (`level_pivot`)
  jackknife,           ///< estimate -+ t standard errors over participants
  score_test,          ///< inverted (`level_interval`, `logistic_level_interval`)
  expanded_percentile  ///< bootstrap over participants (`percentile_interval` at `expanded_levels`)
};

struct ThresholdRule {
  const char* name;             ///< "PT", as `word(JointQuantity)` has it
  const char* key;              ///< "perceptual_threshold": of fields, before the unit
  const char* meaning;          ///< "mean noticeability is 0.5"
  std::optional<double> level;  ///< of mean noticeability; none: IP and the detection threshold
  CurveEstimator estimator;
  IntervalMethod interval;
  ThresholdEstimate CurveThresholds::*estimate;  ///< null for those of the joint model
};

/// The thresholds of record. Those corrected for guessing are of what is seen alone.
inline constexpr std::array<ThresholdRule, 6> threshold_rules = {
    {{"PT", "perceptual_threshold", "mean noticeability, lucky guesses included, is 0.5", perceptual_level,
      CurveEstimator::joint, IntervalMethod::jackknife_test, nullptr},
     {"SN", "slightly_noticeable", "mean noticeability, lucky guesses included, is 1.0", slight_level,
      CurveEstimator::joint, IntervalMethod::jackknife_test, nullptr},
     {"PT corrected", "perceptual_threshold_corrected", "mean noticeability of what is seen is 0.5",
      perceptual_level, CurveEstimator::joint, IntervalMethod::jackknife_test, nullptr},
     {"SN corrected", "slightly_noticeable_corrected", "mean noticeability of what is seen is 1.0",
      slight_level, CurveEstimator::joint, IntervalMethod::jackknife_test, nullptr},
     {"IP", "inflection", "mean noticeability is steepest", std::nullopt, CurveEstimator::joint,
      IntervalMethod::jackknife, nullptr},
     {"detection", "detection", "half of all insertions are seen", std::nullopt, CurveEstimator::joint,
      IntervalMethod::jackknife_test, nullptr}}};

/// The paper's own way, for those who replicate it: it stands beside the thresholds of record.
inline constexpr std::array<ThresholdRule, 3> paper_rules = {
    {{"PT", "perceptual_threshold", "the isotonic means, joined by straight lines, are 0.5", perceptual_level,
      CurveEstimator::isotonic, IntervalMethod::score_test, &CurveThresholds::perceptual},
     {"SN", "slightly_noticeable", "the isotonic means, joined by straight lines, are 1.0", slight_level,
      CurveEstimator::isotonic, IntervalMethod::score_test, &CurveThresholds::slightly_noticeable},
     {"IP", "inflection", "the centre of a logistic through the means", std::nullopt,
      CurveEstimator::logistic, IntervalMethod::expanded_percentile, &CurveThresholds::inflection}}};

/// Each rule as a sentence, those of record first; then when there is an estimate, and what holds for several
/// thresholds.
[[nodiscard]] std::vector<std::string> sentences_of_rules();

/// How intervals are made, of both tables.
[[nodiscard]] std::string intervals_in_short();

/// "PT and SN": the thresholds of the paper's way whose interval is made so.
[[nodiscard]] std::string names_with(IntervalMethod method);

}  // namespace seamline::analysis
