#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "study/placement/psychometric_function.h"

namespace seamline::analysis {

/// Answers at one level of a stimulus.
struct LevelCounts {
  double level = 0;          ///< in the user's unit, e.g. px
  std::int64_t correct = 0;  ///< right choices; "yes" answers in a yes/no task; 0 to `trials`
  std::int64_t trials = 0;

  [[nodiscard]] double share() const { return static_cast<double>(correct) / static_cast<double>(trials); }
};

/// Reads a CSV file (support/text/csv_read.h) whose header line names the columns `level`, `correct` and
/// `trials`, in any order; other columns are ignored. Throws InputError naming file and line when a value is
/// missing, is not a number, is not positive on a log2 axis, is not whole or is more than 1e12 where it
/// counts, or when more answers are correct than were given.
[[nodiscard]] std::vector<LevelCounts> read_level_counts(const std::filesystem::path& file,
                                                         study::Axis axis = study::Axis::linear);

/// Equal levels added up, rising, levels without a trial left out.
[[nodiscard]] std::vector<LevelCounts> pooled_by_level(const std::vector<LevelCounts>& counts);

/// Throws InputError (field `level`, `correct` or `trials`) unless every level is finite, positive on a log2
/// axis, and 0 <= correct <= trials.
void require_valid(const std::vector<LevelCounts>& counts, study::Axis axis);

/// a(x) = x or log2 x, and back.
[[nodiscard]] double axis_value(study::Axis axis, double level);
[[nodiscard]] double level_of(study::Axis axis, double axis_value);

}  // namespace seamline::analysis
