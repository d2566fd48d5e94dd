#pragma once
#include <cstdint>
#include <vector>

#include "study/placement/psychometric_function.h"

namespace seamline::analysis {

/// Answers at one level of a stimulus. Level 0 on a log2 axis is "no stimulus": infinitely far down the axis,
/// where psi is the guess rate of a rising function and 1 - lapse of a falling one.
struct LevelCounts {
  double level = 0;          ///< in the user's unit, e.g. px
  std::int64_t correct = 0;  ///< right choices; "yes" answers in a yes/no task; 0 to `trials`
  std::int64_t trials = 0;

  [[nodiscard]] double share() const { return static_cast<double>(correct) / static_cast<double>(trials); }
};

/// Equal levels added up, rising, levels without a trial left out.
[[nodiscard]] std::vector<LevelCounts> pooled_by_level(const std::vector<LevelCounts>& counts);

/// Throws InputError (field `level`, `correct` or `trials`) unless every level is finite, not negative on a
/// log2 axis, and 0 <= correct <= trials.
void require_valid(const std::vector<LevelCounts>& counts, study::Axis axis);

/// Takes the answers without a stimulus (level 0 on a log2 axis) out of levels that are pooled and rising.
[[nodiscard]] LevelCounts take_no_stimulus(std::vector<LevelCounts>& pooled, study::Axis axis);

/// a(x) = x or log2 x, and back.
[[nodiscard]] double axis_value(study::Axis axis, double level);
[[nodiscard]] double level_of(study::Axis axis, double axis_value);

}  // namespace seamline::analysis
