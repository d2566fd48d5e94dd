#pragma once
#include <optional>
#include <string>

#include "analysis/foresight/plan_study.h"

namespace seamline::analysis {

/// A design that gives the wanted median width of every interval that can be had.
struct PlannedDesign {
  std::size_t width_set = 0;
  int participants = 0;
};

/// Whether every interval of a design that can be had is narrow enough, and at least one can be had.
[[nodiscard]] bool meets_wish(const StudyPlan& plan, const PlannedDesign& design);

/// The design that meets the wish with the fewest participants (then the fewest widths), none when no design
/// tried does.
[[nodiscard]] std::optional<PlannedDesign> fewest_participants(const StudyPlan& plan);

/// The one with the fewest answers, participants times widths.
[[nodiscard]] std::optional<PlannedDesign> fewest_answers(const StudyPlan& plan);

/// The table for a terminal, and the designs that meet the wish.
[[nodiscard]] std::string plan_text(const StudyPlan& plan);

}  // namespace seamline::analysis
