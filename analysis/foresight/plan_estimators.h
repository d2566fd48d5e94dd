#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "analysis/foresight/plan_targets.h"
#include "analysis/statistics/estimate.h"

namespace seamline::analysis {

/// Which analysis a plan foresees.
enum class PlanEstimator {
  joint,          ///< one model of seeing, guessing and rating (documentation/explanation/joint_model.md)
  straight_lines  ///< the paper's: isotonic means joined by straight lines, inverted score tests
};
[[nodiscard]] std::string_view word(PlanEstimator estimator);
/// For readers: "straight lines between isotonic means (the paper's way)".
[[nodiscard]] std::string_view name_of(PlanEstimator estimator);

[[nodiscard]] std::optional<PlanEstimator> plan_estimator_from_word(std::string_view text);

/// The 95 % intervals of the targets from the first `people` participants, in x of LevelAxis (differences: of
/// x). `seed` is of resampling, where there is any.
[[nodiscard]] std::vector<LevelInterval> planned_intervals(PlanEstimator estimator,
                                                           const std::vector<PlannedCurve>& curves,
                                                           const SimulatedAnswers& answers, int people,
                                                           const std::vector<PlanTarget>& targets,
                                                           std::uint64_t seed);

/// What the estimates of the targets approach with ever more people, from the exact shares of answers at
/// these levels; none where the level lies beyond them.
[[nodiscard]] std::vector<std::optional<double>> limits_of(PlanEstimator estimator,
                                                           const PlannedPopulation& population,
                                                           const std::vector<PlannedCurve>& curves,
                                                           const std::vector<PlanTarget>& targets,
                                                           const std::vector<double>& level_x);

}  // namespace seamline::analysis
