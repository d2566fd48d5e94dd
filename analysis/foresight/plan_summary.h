#pragma once
#include <vector>

#include "analysis/foresight/plan_study.h"

namespace seamline::analysis {

/// What one simulated study found, at each set of levels and number of participants (set outermost).
struct SimulatedStudy {
  std::vector<std::vector<LevelInterval>> intervals;  ///< one a target
  std::vector<std::vector<bool>> no_seam;             ///< one a curve; empty where no claim is made
};

/// Whether two one-sided t tests over participants, at 5 % each, put the corrected mean noticeability of each
/// curve at the claim's level within its margin of 0. Empty where no claim is made or these levels do not
/// have its.
[[nodiscard]] std::vector<bool> claims_shown(const PlanRequest& request, const StudyPlan& plan,
                                             const SimulatedAnswers& answers, int people);

/// Sets the rows, designs and sequential rows of a plan whose targets and level sets are known.
void summarise(const std::vector<SimulatedStudy>& studies, const PlannedPopulation& population,
               StudyPlan& plan);

}  // namespace seamline::analysis
