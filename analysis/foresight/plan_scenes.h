#pragma once
#include <array>
#include <string>

#include "analysis/foresight/plan_study.h"

namespace seamline::analysis {

/// Numbers of scenes that a plan looks at, besides one.
inline constexpr std::array planned_scenes = {3, 5, 10};

/// "Assumed of scenes: their thresholds have a standard deviation of 0.5 octaves."; empty where nothing is
/// assumed.
[[nodiscard]] std::string scenes_assumed_text(const PlanRequest& request, const LevelAxis& axis);

/// Lengths of 95 % intervals over people and scenes for `planned_scenes`, and what each number may claim;
/// empty where nothing is assumed of scenes. With the study's own levels. The variance over people is that of
/// the median interval, so a scene more is taken to say nothing more of people; that of scenes is
/// between^2 / scenes (`expected_spreads`).
[[nodiscard]] std::string scenes_plan_text(const StudyPlan& plan);

}  // namespace seamline::analysis
