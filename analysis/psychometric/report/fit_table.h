#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/likelihood/level_counts.h"

namespace seamline::analysis {

/// Which columns of a table hold what, as the command line names them; empty: found by usual names.
struct FitColumns {
  std::string level, correct, trials;
  std::string times;               ///< how often the answer of a row was given; instead of `trials`
  std::string participant, group;  ///< used only when they are named
};

/// A row of the table. `participant` and `group` are places in the table's lists, 0 without such a column.
struct FitRow {
  LevelCounts counts;
  std::size_t participant = 0, group = 0;
};

/// Counts as people bring them.
struct FitTable {
  std::vector<FitRow> rows;
  std::vector<std::string> participants, groups;  ///< in the order of the file; empty without such a column
  std::vector<std::string> ignored;               ///< names of the columns that are not used
  std::vector<std::string> remarks;               ///< sentences on how the file was understood
};

inline constexpr std::size_t most_fit_groups = 50;
inline constexpr std::size_t most_fit_participants = 10'000;

/// Reads a CSV file (support/text/csv_read.h). Without a name in `columns` the level is `level`, `x`,
/// `intensity` or `stimulus`; right answers are `correct`, `k`, `right`, `yes`, `n_correct` or `response`;
/// trials are `trials`, `n`, `n_trials` or `total`, in large or small letters; the first of these lists is
/// taken where it is there, another only when no second one is. Without a column of trials a row is one
/// answer: 0 or 1, `no` or `yes`, `false` or `true`. Where semicolons or tabs stand between the values and no
/// number has a point, commas are decimal signs. Throws InputError naming file and line for a value that
/// is missing, no number, negative on a log2 axis, not whole or more than 1e12 where it counts, for more
/// right answers than trials, a column that is not there or named for two things, names that leave a choice,
/// decimal points beside decimal commas, an empty participant or group, and more groups or participants than
/// the limits above.
[[nodiscard]] FitTable read_fit_table(const std::filesystem::path& file, const FitColumns& columns,
                                      study::Axis axis);

/// All rows, or those of one group.
[[nodiscard]] std::vector<LevelCounts> counts_of(const FitTable& table,
                                                 std::optional<std::size_t> group = std::nullopt);

}  // namespace seamline::analysis
