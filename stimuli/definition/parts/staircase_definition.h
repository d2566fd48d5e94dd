#pragma once
#include <string>
#include <vector>

namespace seamline::inline stimuli {

/// `procedure = "staircase"` with its table `[staircase]`: levels follow the answers, one step at a time.
struct StaircaseDefinition {
  int down = 2;         ///< so many right answers in a row lead to the next level where less is seen
  int up = 1;           ///< so many wrong ones to the next level where more is seen
  int reversals = 8;    ///< a staircase ends when it has turned so often,
  int max_trials = 60;  ///< or after so many answers
  /// Levels at which the staircases of a curve begin, one staircase each; empty: one, where most is seen.
  std::vector<double> start = {};
  bool by_object = false;  ///< staircases of each object's own; else those of a curve show all its objects
  bool operator==(const StaircaseDefinition&) const = default;
};

/// Its meaning as text, for the study's hash.
[[nodiscard]] std::string canonical_text(const StaircaseDefinition& definition);

}  // namespace seamline::inline stimuli
