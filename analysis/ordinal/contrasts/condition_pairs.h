#pragma once
#include <span>
#include <string>
#include <vector>

#include "analysis/ordinal/contrasts/study_model.h"

namespace seamline::analysis {

/// Artifacts in conditions that one model holds. Each has parameters of its own and the model is fitted to
/// all answers at once, so its time and memory grow with the square of their number and more.
inline constexpr std::size_t most_cells_of_a_model = 100;

/// How many artifacts in conditions there are.
[[nodiscard]] std::size_t count_cells(std::span<const study::Answer> answers);

/// What studies with too many conditions for one model are told of them.
struct ConditionPairs {
  std::vector<ContrastTable> tables;  ///< levels, slopes; each with at least one contrast
  std::vector<std::string> notes;     ///< a sentence each
};

/// Every condition against its artifact's first, each in a model of these two conditions alone (artifacts,
/// slopes, objects, groups and participants as in the study's own model), so that time grows with their
/// number; p values of a question are adjusted together by Holm. Compared at `reference_level`, which is not
/// 0. Pairs whose model has no estimate are not estimable, and a note says how many and why the first.
[[nodiscard]] ConditionPairs compare_condition_pairs(std::span<const study::Answer> answers,
                                                     const ParticipantGroups& groups,
                                                     const OrdinalStudyRequest& request,
                                                     double reference_level);

}  // namespace seamline::analysis
