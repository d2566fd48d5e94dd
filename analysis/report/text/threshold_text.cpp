#include "analysis/report/text/threshold_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "analysis/log_analysis/headline_rows.h"
#include "analysis/log_analysis/task_words.h"
#include "analysis/scores/level_words.h"
#include "analysis/thresholds/paper_values.h"

namespace seamline::analysis {

namespace {

std::string edge_text(double level, const TestedLevels& tested) {
  if (level == -infinity) return "below " + tested_text(tested.axis, tested.smallest);
  if (level == infinity) return "above " + tested_text(tested.axis, tested.largest);
  return estimated_text(tested.axis, level);
}

std::string level_text(const ThresholdEstimate& estimate, const LevelAxis& axis) {
  const std::optional<double> level = level_of(estimate, axis);
  return level ? estimated_text(axis, *level) : reason_text(estimate, axis);
}

}  // namespace

std::string artifact_title(Artifact artifact, const std::string& condition) {
  std::string title(word(artifact));
  title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
  if (const std::optional<PaperThresholds> paper = paper_thresholds(artifact))
    title += fmt::format(" (type {})", paper->type);
  return condition.empty() ? title : title + ", " + condition;
}

std::string size_text(const ThresholdEstimate& estimate, const LevelAxis& axis, const std::string& times) {
  if (!estimate.level_x || !of_depth_widths(axis)) return level_text(estimate, axis);
  const double width_px = level_at(axis, *estimate.level_x);
  return fmt::format("{:.0f} {} {:.0f}", width_px, times, width_px / 2);
}

bool has_end(const LevelInterval& interval) {
  return std::isfinite(interval.low_x) || std::isfinite(interval.high_x);
}

std::string interval_text(const LevelInterval& interval, const TestedLevels& tested) {
  const LevelRange range = range_at(tested.axis, interval);
  // Beyond the levels that were tested an open interval has no other end that means anything.
  const bool is_below = range.low == -infinity && range.high <= tested.smallest;
  const bool is_above = range.high == infinity && range.low >= tested.largest;
  if (is_below || is_above) return edge_text(is_below ? range.low : range.high, tested);
  return edge_text(range.low, tested) + " to " + edge_text(range.high, tested);
}

std::string estimate_text(const ThresholdEstimate& estimate, const TestedLevels& tested) {
  return fmt::format("{} ({})", level_text(estimate, tested.axis), interval_text(estimate.ci95, tested));
}

namespace {

constexpr std::size_t widest_line = 160, between_columns = 2;

/// Letters, not bytes.
std::size_t letters_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// A cell in lines of at most so many letters; a word that is longer stays whole.
std::vector<std::string> wrapped(const std::string& cell, std::size_t width) {
  std::vector<std::string> lines(1);
  for (std::size_t at = 0; at < cell.size();) {
    const std::size_t space = std::min(cell.find(' ', at + 1), cell.size());
    const std::string word = cell.substr(at, space - at);  // with the blank before it
    if (!lines.back().empty() && letters_of(lines.back() + word) > width)
      lines.push_back(word.substr(1));
    else
      lines.back() += word;
    at = space;
  }
  return lines;
}

/// The narrowest that a column can be.
std::size_t longest_word(const std::string& cell) {
  std::size_t longest = 0;
  for (const std::string& line : wrapped(cell, 0)) longest = std::max(longest, letters_of(line));
  return longest;
}

/// As wide as the widest cell; the widest of those that can be broken are narrower where a line would be too
/// long.
std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.front().size()), least(widths.size());
  for (const std::vector<std::string>& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], letters_of(line[i]));
      least[i] = std::max(least[i], longest_word(line[i]));
    }
  std::size_t all = between_columns * (widths.size() - 1);
  for (const std::size_t width : widths) all += width;
  for (; all > widest_line; --all) {
    std::size_t widest = widths.size();
    for (std::size_t i = 0; i < widths.size(); ++i)
      if (widths[i] > least[i] && (widest == widths.size() || widths[i] > widths[widest])) widest = i;
    if (widest == widths.size()) break;
    --widths[widest];
  }
  return widths;
}

}  // namespace

std::string aligned(const std::vector<std::vector<std::string>>& lines) {
  const std::vector<std::size_t> widths = widths_of(lines);
  std::string text;
  for (const std::vector<std::string>& line : lines) {
    std::vector<std::vector<std::string>> cells;
    std::size_t height = 1;
    for (std::size_t i = 0; i < line.size(); ++i) {
      cells.push_back(wrapped(line[i], widths[i]));
      height = std::max(height, cells.back().size());
    }
    for (std::size_t k = 0; k < height; ++k) {
      std::string row;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string part = k < cells[i].size() ? cells[i][k] : "";
        row += part + std::string(widths[i] + between_columns - std::min(widths[i], letters_of(part)), ' ');
      }
      text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
    }
  }
  return text;
}

namespace {

/// Titles of columns, and cells of a line each.
std::vector<std::vector<std::string>> headline_lines(const Analysis& analysis, bool simulated, bool paper) {
  const std::string of_width = of_depth_widths(analysis.data.axis) ? " (W)" : "";
  const bool papers_way = asks_ratings(analysis.log);
  std::vector<std::vector<std::string>> lines = {{"artifact", "", "joint model", "95 % interval" + of_width}};
  if (papers_way) lines.front().emplace_back("paper's way");
  if (paper) lines.front().push_back("paper" + of_width);
  if (simulated) lines.front().push_back("planted" + of_width);
  const HeadlineRow* last = nullptr;
  const std::vector<HeadlineRow> rows = headline_rows(analysis);
  for (const HeadlineRow& row : rows) {
    const bool first = last == nullptr || last->artifact != row.artifact || last->condition != row.condition;
    lines.push_back({first ? artifact_title(row.artifact, row.condition) : "", row.rule->name,
                     size_text(row.here, row.tested.axis, "x"),
                     has_end(row.here.ci95) ? interval_text(row.here.ci95, row.tested) : ""});
    if (papers_way)
      lines.back().push_back(row.paper_way
                                 ? (row.paper_way->level_x ? estimate_text(*row.paper_way, row.tested)
                                                           : reason_text(*row.paper_way, row.tested.axis))
                                 : "");
    if (paper) lines.back().push_back(row.paper_px ? std::to_string(*row.paper_px) : "-");
    if (simulated) lines.back().push_back(row.planted ? level_text(*row.planted, row.tested.axis) : "");
    last = &row;
  }
  return lines;
}

std::vector<std::vector<std::string>> paper_way_lines(const Analysis& analysis, bool simulated, bool paper) {
  const std::string of_width = of_depth_widths(analysis.data.axis) ? " (W)" : "";
  std::vector<std::vector<std::string>> lines = {{"artifact", "", "here", "95 % interval" + of_width}};
  if (paper) lines.front().push_back("paper" + of_width);
  if (simulated) lines.front().push_back("planted" + of_width);
  for (const ThresholdRow& row : threshold_rows(analysis)) {
    lines.push_back({row.quantity == "PT" ? artifact_title(row.artifact, row.condition) : "", row.quantity,
                     size_text(row.here, analysis.data.axis, "x"), interval_text(row.here.ci95, row.tested)});
    if (paper) lines.back().push_back(row.paper_px ? std::to_string(*row.paper_px) : "-");
    if (simulated)
      lines.back().push_back(row.planted_x ? estimated_text(analysis.data.axis, *planted_level(row))
                                           : std::string());
  }
  return lines;
}

}  // namespace

std::string table_text(const Analysis& analysis) {
  const bool simulated = !analysis.planted.empty() || !planted_detection(analysis).empty(),
             paper = beside_the_paper(analysis);
  const LevelAxis& axis = analysis.data.axis;
  std::string text =
      (of_depth_widths(axis) ? std::string("Depth map width W x height in px") : axis_title(axis)) + "; " +
      source_text(analysis) + "\n" +
      aligned(analysis.joint ? headline_lines(analysis, simulated, paper)
                             : paper_way_lines(analysis, simulated, paper));
  if (!asks_ratings(analysis.log))
    return text + "Detection: half is seen, with chance taken out." +
           (simulated ? " Planted: where the simulated observers see half.\n" : "\n");
  text += "PT: mean noticeability 0.5; SN: 1.0; IP: inflection point.";
  if (analysis.joint)
    text +=
        " Corrected: of what is seen, without lucky guesses. Detection: half is seen.\nPaper's way: straight "
        "lines between the tested levels, and the centre of a logistic.";
  text += paper ? " -: the paper gives no value.\n" : "\n";
  if (simulated)
    text += "Planted: where the simulated observers' expected mean truly crosses; not the paper's values.\n" +
            design_bias_text(analysis);
  return text;
}

std::string design_bias_text(const Analysis& analysis) {
  constexpr double worth_saying_x = 0.1;
  std::vector<std::string> biased;
  const LevelAxis& axis = analysis.data.axis;
  for (const ThresholdRow& row : threshold_rows(analysis)) {
    const std::optional<double> bias_x = design_bias_x(row);
    if (!bias_x || std::abs(*bias_x) < worth_saying_x) continue;
    biased.push_back(fmt::format("{} of {}{} {} ({:+.2f} {})", row.quantity, word(row.artifact),
                                 in_condition(row.condition),
                                 estimated_text(axis, level_at(axis, *row.limit->level_x)),
                                 difference_at(axis, *bias_x), length_unit(axis)));
  }
  if (biased.empty()) return "";
  return fmt::format(
      "Bias of the design: with ever more people, straight lines (and the logistic) through these {}s "
      "approach "
      "other values than the planted ones: {}.\n",
      level_word(axis), fmt::join(biased, ", "));
}

}  // namespace seamline::analysis
