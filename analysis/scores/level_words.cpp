#include "analysis/scores/level_words.h"

#include <fmt/format.h>

#include <cmath>

namespace seamline::analysis {

LevelWords level_words(const LevelAxis& axis) {
  const bool widths = of_depth_widths(axis), rises = axis.noticeability == Direction::increasing;
  const std::string quantity(facts(axis.quantity).name);
  LevelWords words{.level = widths ? "width" : "level",
                   .levels = widths ? "widths" : "levels",
                   .Levels = widths ? "Widths" : "Levels",
                   .quantity = quantity,
                   .sought = {},
                   .symbol = widths ? "width W" : "level",
                   .axis = is_linear(axis) ? "the level"
                           : widths        ? "log2 width"
                                           : "log2 level",
                   .short_axis = is_linear(axis) ? "the level"
                                 : widths        ? "log2 W"
                                                 : "log2 level",
                   .with_level = widths ? "with width" : "with the level",
                   .falls = rises ? "rises" : "falls",
                   .fall = rises ? "rise" : "fall",
                   .falling = rises ? "rising" : "falling",
                   .monotone = rises ? "non-decreasing" : "non-increasing"};
  words.sought = fmt::format("the {} {}", rises ? "smallest" : "largest",
                             widths ? "depth map widths" : fmt::format("levels of the {}", quantity));
  return words;
}

std::string reason_text(const ThresholdEstimate& estimate, const LevelAxis& axis) {
  if (!estimate.reason) return "";
  const LevelWords words = level_words(axis);
  const LevelRange ci95 = range_at(axis, estimate.ci95), steepest = range_at(axis, estimate.steepest);
  const auto text = [&](double level) {
    return std::isfinite(level) ? estimated_text(axis, level) : std::string();
  };
  return fmt::format(fmt::runtime(sentence(*estimate.reason)), fmt::arg("level", words.level),
                     fmt::arg("levels", words.levels), fmt::arg("fall", words.fall),
                     fmt::arg("with_level", words.with_level), fmt::arg("low", text(ci95.low)),
                     fmt::arg("high", text(ci95.high)), fmt::arg("steepest_low", text(steepest.low)),
                     fmt::arg("steepest_high", text(steepest.high)));
}

}  // namespace seamline::analysis
