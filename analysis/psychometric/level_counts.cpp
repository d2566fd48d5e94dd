#include "analysis/psychometric/level_counts.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <string>

#include "stimuli/support/atomic_file.h"
#include "stimuli/support/csv.h"
#include "stimuli/support/error.h"

namespace seamline {

namespace {

constexpr std::int64_t largest_count = 1'000'000'000'000;  ///< whole numbers stay exact as doubles

std::string trimmed(std::string text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && blank(text.back())) text.pop_back();
  const auto first = std::find_if_not(text.begin(), text.end(), blank);
  return {first, text.end()};
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t comma = line.find(',', begin);
    cells.push_back(trimmed(line.substr(begin, comma - begin)));
    if (comma == std::string::npos) return cells;
    begin = comma + 1;
  }
}

/// Where the three columns are.
struct Columns {
  std::size_t level = 0, correct = 0, trials = 0;
};

Columns columns_of(const std::string& header, const std::string& file) {
  const std::vector<std::string> names = cells_of(header);
  const auto place = [&](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw input_error({.file = file,
                         .field = "line 1",
                         .wanted = "a header with the columns level,correct,trials",
                         .found = "no column '" + name + "' in '" + trimmed(header) + "'"});
    return static_cast<std::size_t>(found - names.begin());
  };
  return {.level = place("level"), .correct = place("correct"), .trials = place("trials")};
}

/// A cell of a line as a number; a sentence that names file and line when it is none.
class Line {
 public:
  Line(const std::string& file, int number, const std::string& text)
      : file_(file), number_(number), cells_(cells_of(text)) {}

  [[nodiscard]] double number(std::size_t column, const char* name) const {
    const std::string text = column < cells_.size() ? cells_[column] : "";
    double value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value))
      throw complaint(name, "a number", text.empty() ? "nothing" : "'" + text + "'");
    return value;
  }

  [[nodiscard]] std::int64_t count(std::size_t column, const char* name) const {
    const double value = number(column, name);
    if (value < 0 || value != std::floor(value) || value > static_cast<double>(largest_count))
      throw complaint(name, "a whole number that is not negative", number_text(value));
    return static_cast<std::int64_t>(value);
  }

  [[nodiscard]] InputError complaint(const char* name, const std::string& wanted,
                                     const std::string& found) const {
    return input_error({.file = file_,
                        .field = "line " + std::to_string(number_) + ": " + name,
                        .wanted = wanted,
                        .found = found});
  }

 private:
  std::string file_;
  int number_;
  std::vector<std::string> cells_;
};

}  // namespace

std::vector<LevelCounts> read_level_counts(const std::filesystem::path& file) {
  std::istringstream in(read_file(file, limits::largest_csv_bytes));
  std::string text;
  if (!std::getline(in, text))
    throw input_error({.file = file.string(),
                       .field = "line 1",
                       .wanted = "a header with the columns level,correct,trials",
                       .found = "an empty file"});
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  const Columns columns = columns_of(text, file.string());
  std::vector<LevelCounts> counts;
  for (int number = 2; std::getline(in, text); ++number) {
    if (trimmed(text).empty()) continue;
    if (static_cast<std::int64_t>(counts.size()) >= limits::largest_csv_rows)
      throw input_error({.file = file.string(),
                         .field = "line " + std::to_string(number),
                         .wanted = "at most " + std::to_string(limits::largest_csv_rows) + " lines of counts",
                         .found = "more"});
    const Line line(file.string(), number, text);
    counts.push_back({.level = line.number(columns.level, "level"),
                      .correct = line.count(columns.correct, "correct"),
                      .trials = line.count(columns.trials, "trials")});
    if (counts.back().correct > counts.back().trials)
      throw line.complaint("correct", "at most the " + std::to_string(counts.back().trials) + " trials",
                           std::to_string(counts.back().correct));
  }
  if (counts.empty())
    throw input_error(
        {.file = file.string(), .field = "", .wanted = "at least one line of counts", .found = "none"});
  return counts;
}

std::vector<LevelCounts> pooled_by_level(const std::vector<LevelCounts>& counts) {
  std::map<double, LevelCounts> levels;
  for (const LevelCounts& row : counts) {
    if (row.trials == 0) continue;
    LevelCounts& level = levels[row.level];
    level.level = row.level;
    level.correct += row.correct;
    level.trials += row.trials;
  }
  std::vector<LevelCounts> pooled;
  for (const auto& [value, level] : levels) pooled.push_back(level);
  return pooled;
}

void require_valid(const std::vector<LevelCounts>& counts, Axis axis) {
  for (const LevelCounts& row : counts) {
    if (!std::isfinite(row.level))
      throw input_error({.field = "level", .wanted = "a finite number", .found = number_text(row.level)});
    if (axis == Axis::log2 && row.level <= 0)
      throw input_error({.field = "level",
                         .wanted = "a positive number on a log2 axis (a linear axis takes any)",
                         .found = number_text(row.level)});
    if (row.trials < 0)
      throw input_error({.field = "trials", .wanted = "0 or more", .found = std::to_string(row.trials)});
    if (row.correct < 0 || row.correct > row.trials)
      throw input_error({.field = "correct",
                         .wanted = "from 0 to the " + std::to_string(row.trials) + " trials",
                         .found = std::to_string(row.correct)});
  }
}

double axis_value(Axis axis, double level) {
  return axis == Axis::log2 ? std::log2(level) : level;
}

double level_of(Axis axis, double value) {
  return axis == Axis::log2 ? std::exp2(value) : value;
}

}  // namespace seamline
