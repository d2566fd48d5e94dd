#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace seamline::inline window {

/// The characters of a UTF-8 text; bytes that are none become U+FFFD.
[[nodiscard]] std::u32string characters_of(std::string_view utf8);

/// The characters of a text, one paragraph for each of its lines. Control characters become spaces.
[[nodiscard]] std::vector<std::u32string> lines_of(std::string_view utf8);

}  // namespace seamline::inline window
