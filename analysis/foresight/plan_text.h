#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/foresight/plan_study.h"

namespace seamline::analysis {

/// Targets whose design bias at a set of levels is more than half the wanted length: the intervals end up
/// beside the truth, and more people make it worse.
[[nodiscard]] std::vector<std::size_t> biased_targets(const StudyPlan& plan, std::size_t level_set);

/// Whether a design gives every interval that can be had as short as wanted with the wanted chance, at least
/// one can be had, and none is biased.
[[nodiscard]] bool meets_wish(const StudyPlan& plan, const DesignRow& design);

/// The design that meets the wish with the fewest participants (then the fewest levels), none when no design
/// tried does. `level_set`: of these levels alone.
[[nodiscard]] std::optional<DesignRow> fewest_participants(const StudyPlan& plan,
                                                           std::optional<std::size_t> level_set = {});

/// The one with the fewest answers, participants times levels.
[[nodiscard]] std::optional<DesignRow> fewest_answers(const StudyPlan& plan);

/// "with a chance of 80 % (200 simulated studies) all 95 % intervals of PT and SN are at most 1 octave long".
[[nodiscard]] std::string wish_text(const StudyPlan& plan);

/// What was assumed, the tables, the designs that meet the wish, and what to be warned of.
[[nodiscard]] std::string plan_text(const StudyPlan& plan);

}  // namespace seamline::analysis
