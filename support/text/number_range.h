#pragma once
#include <string>
#include <string_view>

namespace seamline {

/// The numbers that a key of a file or an option may hold, ends included, and their unit for the sentence of
/// complaint.
struct NumberRange {
  double least;
  double most;
  std::string_view unit = {};
};

/// Only for numbers: NaN is never inside.
[[nodiscard]] constexpr bool inside(double value, NumberRange range) {
  return value >= range.least && value <= range.most;
}

/// "a number from 1 to 170 degrees", for the kind "a number".
[[nodiscard]] std::string range_text(const char* kind, NumberRange range);

}  // namespace seamline
