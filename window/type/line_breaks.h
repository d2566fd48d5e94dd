#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace seamline::inline window {

/// Whether a line may end after each character of a paragraph (UAX #14; in Thai between words).
[[nodiscard]] std::vector<bool> line_may_end(std::u32string_view paragraph, const std::string& language);

}  // namespace seamline::inline window
