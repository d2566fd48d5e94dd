#include "analysis/scores/level_words.h"

#include <fmt/format.h>

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

}  // namespace seamline::analysis
