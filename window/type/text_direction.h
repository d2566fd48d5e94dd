#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

namespace seamline::inline window {

/// Whether texts in a language run from right to left, by its tag of BCP 47 ("he", "az-Arab").
[[nodiscard]] bool runs_right_to_left(std::string_view language);

/// The embedding level of each character of a paragraph (Unicode's bidirectional algorithm, UAX #9): odd
/// where it is read from right to left.
[[nodiscard]] std::vector<std::uint8_t> direction_levels(std::u32string_view paragraph, bool right_to_left);

/// In which order parts of a line stand from left to right, by their levels (rule L2 of UAX #9).
[[nodiscard]] std::vector<std::size_t> order_on_line(const std::vector<std::uint8_t>& levels);

}  // namespace seamline::inline window
