#pragma once
#include <string_view>

namespace seamline::inline stimuli {

/// The axis on which a psychometric function is a sigmoid: the level itself, or its log2.
enum class Axis { linear, log2 };

/// Whether the probability of a response rises or falls with the level.
enum class Direction { increasing, decreasing };

/// "rises" or "falls", as in study files.
[[nodiscard]] constexpr std::string_view noticeability_word(Direction direction) {
  return direction == Direction::increasing ? "rises" : "falls";
}

}  // namespace seamline::inline stimuli
