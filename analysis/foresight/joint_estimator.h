#pragma once
#include <optional>
#include <vector>

#include "analysis/foresight/plan_targets.h"
#include "analysis/statistics/estimate.h"

namespace seamline::analysis {

/// The 95 % intervals of the targets by the joint model (analysis/joint), as `analyze` computes them. All are
/// open where the model has no numbers. A difference is as closed as both thresholds are: estimate -+ t
/// standard errors of the jackknife over people.
[[nodiscard]] std::vector<LevelInterval> joint_intervals(const std::vector<PlannedCurve>& curves,
                                                         const SimulatedAnswers& answers, int people,
                                                         const std::vector<PlanTarget>& targets);

/// What the joint model finds, in x, of each target in a very large study: fitted to the expected shares of
/// all answers at these levels. None where it finds none.
[[nodiscard]] std::vector<std::optional<double>> joint_limits(const PlannedPopulation& population,
                                                              const std::vector<PlannedCurve>& curves,
                                                              const std::vector<PlanTarget>& targets,
                                                              const std::vector<double>& level_x);

}  // namespace seamline::analysis
