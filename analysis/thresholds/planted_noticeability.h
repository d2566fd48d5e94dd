#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/scores/level_axis.h"
#include "analysis/thresholds/thresholds.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::analysis {

/// The level that the average `threshold` observer sees half of the time; none where nothing is planted.
[[nodiscard]] std::optional<double> planted_midpoint(const ObserverDefinition& observer, Artifact artifact,
                                                     const std::string& condition);

/// Mean noticeability of `threshold` observers with that midpoint at a level that does not stand apart.
[[nodiscard]] double planted_noticeability(const ObserverDefinition& observer, const LevelAxis& axis,
                                           double midpoint, double level);

/// Where the mean noticeability of `threshold` observers truly lies: x of LevelAxis, whatever was tested.
/// Exact to 1e-9 for PT and SN, to 1e-4 scales of the observers for IP.
struct PlantedThresholds {
  double perceptual_x = 0, slightly_noticeable_x = 0;  ///< it equals 0.5, and 1
  double inflection_x = 0;                             ///< it falls most steeply
  /// What the paper's estimators find in the exact means at the levels tested: what its estimates approach
  /// with ever more people. Less the true value it is the bias of the design.
  CurveThresholds limit;
};

/// `levels` are those tested, without one that stands apart, in the order of `comes_before`.
[[nodiscard]] PlantedThresholds planted_thresholds(const ObserverDefinition& observer, const LevelAxis& axis,
                                                   double midpoint, const std::vector<double>& levels);

/// x at which a falling function equals a value, by bisection of a range of which the value lies within.
[[nodiscard]] double falling_crossing(const std::function<double(double x)>& falling, double value,
                                      double low_x, double high_x);

}  // namespace seamline::analysis
