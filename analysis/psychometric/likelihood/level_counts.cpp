#include "analysis/psychometric/likelihood/level_counts.h"

#include <array>
#include <cmath>
#include <string>

#include "support/files/atomic_file.h"
#include "support/running/interrupt.h"
#include "support/text/csv.h"
#include "support/text/csv_read.h"
#include "support/text/error.h"

namespace seamline::analysis {

namespace {

constexpr std::int64_t largest_count = 1'000'000'000'000;  ///< sums over a file's rows stay exact
constexpr const char* largest_count_text = "1e12";
constexpr const char* positive_level = "a positive number on a log2 axis (a linear axis takes any)";

}  // namespace

std::vector<LevelCounts> read_level_counts(const std::filesystem::path& file, study::Axis axis) {
  enum Column : std::size_t { level, correct, trials };
  const std::array<std::string, 3> columns = {"level", "correct", "trials"};
  std::vector<LevelCounts> counts;
  read_csv(file.string(), read_file(file, limits::largest_csv_bytes), columns, [&](const CsvRow& row) {
    stop_if_interrupted();
    const LevelCounts read{.level = number_at(row, level),
                           .correct = count_at(row, correct, largest_count, largest_count_text),
                           .trials = count_at(row, trials, largest_count, largest_count_text)};
    if (axis == study::Axis::log2 && read.level <= 0)
      throw complaint_about(row, level, positive_level, number_text(read.level));
    if (read.correct > read.trials)
      throw complaint_about(row, correct, "at most the " + std::to_string(read.trials) + " trials",
                            std::to_string(read.correct));
    counts.push_back(read);
  });
  if (counts.empty())
    throw input_error(
        {.file = file.string(), .field = "", .wanted = "at least one line of counts", .found = "none"});
  return counts;
}

std::vector<LevelCounts> pooled_by_level(const std::vector<LevelCounts>& counts) {
  std::vector<LevelCounts> pooled;
  for (const LevelCounts& row : counts)
    if (row.trials > 0) pooled.push_back(row);
  std::sort(pooled.begin(), pooled.end(),
            [](const LevelCounts& a, const LevelCounts& b) { return a.level < b.level; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < pooled.size(); ++i) {
    if (pooled[i].level == pooled[last].level) {
      pooled[last].correct += pooled[i].correct;
      pooled[last].trials += pooled[i].trials;
    } else {
      pooled[++last] = pooled[i];
    }
  }
  if (!pooled.empty()) pooled.resize(last + 1);
  return pooled;
}

void require_valid(const std::vector<LevelCounts>& counts, study::Axis axis) {
  for (const LevelCounts& row : counts) {
    if (!std::isfinite(row.level))
      throw input_error({.field = "level", .wanted = "a finite number", .found = number_text(row.level)});
    if (axis == study::Axis::log2 && row.level <= 0)
      throw input_error({.field = "level", .wanted = positive_level, .found = number_text(row.level)});
    if (row.trials < 0)
      throw input_error({.field = "trials", .wanted = "0 or more", .found = std::to_string(row.trials)});
    if (row.correct < 0 || row.correct > row.trials)
      throw input_error({.field = "correct",
                         .wanted = "from 0 to the " + std::to_string(row.trials) + " trials",
                         .found = std::to_string(row.correct)});
  }
}

double axis_value(study::Axis axis, double level) {
  return axis == study::Axis::log2 ? std::log2(level) : level;
}

double level_of(study::Axis axis, double value) {
  return axis == study::Axis::log2 ? std::exp2(value) : value;
}

}  // namespace seamline::analysis
