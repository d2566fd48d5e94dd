#include "analysis/psychometric/likelihood/level_counts.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "support/text/csv.h"
#include "support/text/error.h"

namespace seamline::analysis {

namespace {

constexpr const char* positive_level =
    "a positive number on a log2 axis, or 0 for no stimulus (a linear axis takes any)";

}  // namespace

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

LevelCounts take_no_stimulus(std::vector<LevelCounts>& pooled, study::Axis axis) {
  if (axis != study::Axis::log2 || pooled.empty() || pooled.front().level != 0) return {};
  const LevelCounts none = pooled.front();
  pooled.erase(pooled.begin());
  return none;
}

void require_valid(const std::vector<LevelCounts>& counts, study::Axis axis) {
  for (const LevelCounts& row : counts) {
    if (!std::isfinite(row.level))
      throw input_error({.field = "level", .wanted = "a finite number", .found = number_text(row.level)});
    if (axis == study::Axis::log2 && row.level < 0)
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
