#pragma once
#include <vector>

#include "analysis/psychometric/likelihood/maximise.h"

namespace seamline::analysis {

/// What no function can exceed whose sought level lies between two places: under it performance is at most
/// that of the level, above it at least (the other way round when it falls), and it lies between the guess
/// and the lapse rate everywhere, and never falls as the task gets easier. So ln L is at most that of the
/// likeliest monotone performance within these limits (isotonic regression on either side). It proves parts
/// of the axis empty without a search.
class MonotoneBound {
 public:
  explicit MonotoneBound(const FitProblem& problem) : problem_(problem) {}

  /// Of the objective, for a level at any place from `low` to `high` (unit axis). Infinite when nothing is
  /// known: beta-binomial rows.
  [[nodiscard]] double above(const SoughtLevel& level, double low, double high) const;

 private:
  const FitProblem& problem_;
};

}  // namespace seamline::analysis
