#include "analysis/scores/level_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "study/running/quest_plus_results.h"

namespace seamline::analysis {

namespace {

constexpr double units_in_range = 6;

}  // namespace

LevelAxis level_axis(const study::LogContents& log) {
  LevelAxis axis{.quantity = log.quantity, .noticeability = log.noticeability, .unit = 1};
  if (!is_linear(axis) || log.answers.empty()) return axis;
  const auto [least, most] =
      std::minmax_element(log.answers.begin(), log.answers.end(),
                          [](const study::Answer& a, const study::Answer& b) { return a.level < b.level; });
  if (most->level > least->level) axis.unit = (most->level - least->level) / units_in_range;
  return axis;
}

bool is_linear(const LevelAxis& axis) {
  return facts(axis.quantity).axis == Axis::linear;
}

bool stands_apart(const LevelAxis& axis, double level) {
  return stands_apart(facts(axis.quantity).axis, level);
}

bool of_depth_widths(const LevelAxis& axis) {
  return axis.quantity == Quantity::depth_width_px;
}

double x_of(const LevelAxis& axis, double level) {
  const double along = is_linear(axis) ? level / axis.unit : std::log2(level);
  return axis.noticeability == Direction::increasing ? -along : along;
}

double level_at(const LevelAxis& axis, double level_x) {
  const double along = axis.noticeability == Direction::increasing ? -level_x : level_x;
  return is_linear(axis) ? along * axis.unit : std::exp2(along);
}

bool comes_before(const LevelAxis& axis, double a, double b) {
  const bool a_apart = stands_apart(axis, a), b_apart = stands_apart(axis, b);
  if (a_apart || b_apart) return !a_apart && b_apart;
  return axis.noticeability == Direction::increasing ? b < a : a < b;
}

std::vector<double> x_of_levels(const LevelAxis& axis, const std::vector<double>& levels) {
  std::vector<double> level_x;
  for (const double level : levels)
    if (!stands_apart(axis, level)) level_x.push_back(x_of(axis, level));
  return level_x;
}

double difference_at(const LevelAxis& axis, double difference_x) {
  const double along = axis.noticeability == Direction::increasing ? 0 - difference_x : difference_x;
  return is_linear(axis) ? along * axis.unit : along;
}

LevelRange range_at(const LevelAxis& axis, const LevelInterval& interval) {
  const bool rising = axis.noticeability == Direction::increasing;
  const auto end = [&](double level_x) {
    if (std::isfinite(level_x)) return level_at(axis, level_x);
    return rising ? -level_x : level_x;
  };
  LevelRange range{.low = end(interval.low_x), .high = end(interval.high_x)};
  if (rising) std::swap(range.low, range.high);
  return range;
}

std::string level_word(const LevelAxis& axis) {
  return of_depth_widths(axis) ? "width" : "level";
}

std::string level_key(const LevelAxis& axis) {
  return of_depth_widths(axis) ? "width_px" : std::string(facts(axis.quantity).key);
}

std::string unit_suffix(const LevelAxis& axis) {
  const std::string_view key = facts(axis.quantity).unit_key;
  return key.empty() ? "" : "_" + std::string(key);
}

std::string length_key(const LevelAxis& axis) {
  return study::length_key(facts(axis.quantity).axis, axis.quantity);
}

std::string length_unit(const LevelAxis& axis) {
  return study::length_unit(facts(axis.quantity).axis, axis.quantity);
}

std::string axis_title(const LevelAxis& axis) {
  const QuantityFacts& about = facts(axis.quantity);
  const std::string name = std::string(about.name) + (of_depth_widths(axis) ? " W" : "");
  return about.unit.empty() || about.unit == about.name ? name : fmt::format("{} ({})", name, about.unit);
}

std::string tested_text(const LevelAxis& axis, double level) {
  return stands_apart(axis, level) ? "none" : fmt::format("{}", level);
}

std::string estimated_text(const LevelAxis& axis, double level) {
  if (of_depth_widths(axis)) return fmt::format("{:.0f}", level);
  if (level == 0) return "0";
  const double decimals = 2 - std::floor(std::log10(std::abs(level)));
  return fmt::format("{:.{}f}", level, static_cast<int>(std::clamp(decimals, 0.0, 12.0)));
}

}  // namespace seamline::analysis
