#pragma once
#include <string>
#include <string_view>

namespace seamline::inline window {

/// The characters of a UTF-8 text; bytes that are none become U+FFFD.
[[nodiscard]] std::u32string characters_of(std::string_view utf8);

/// A character whose shape or place depends on its neighbours (Arabic, Hebrew, Indic and South-East Asian
/// scripts, combining marks). The window sets one shape after the other from left to right, so such texts
/// would be wrong.
[[nodiscard]] bool needs_shaping(char32_t character);

/// Throws InputError when a text that the window will show has such a character. `field` says where it is.
void refuse_text_that_needs_shaping(const std::string& file, const std::string& field, std::string_view text);

}  // namespace seamline::inline window
