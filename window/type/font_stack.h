#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "window/type/glyphs.h"
#include "window/type/shaping.h"

namespace seamline::inline window {

/// One font, by its two parts.
struct TypeFont {
  OutlineFont outlines;
  ShapingFont shaping;

  explicit TypeFont(const FontBytes& font) : outlines(font), shaping(font) {}
};

/// Fonts, the one first whose letters are wanted, then those that have what it lacks. Never empty.
using FontStack = std::vector<TypeFont>;

/// The font of each character of a text: the first that has the character and all marks on it, or else the
/// first that has the character alone; the first font where none has it.
[[nodiscard]] std::vector<std::size_t> fonts_of(const FontStack& fonts, std::u32string_view text);

/// The characters of a text that no font has, without repetition.
[[nodiscard]] std::u32string missing_characters(const FontStack& fonts, std::u32string_view text);

}  // namespace seamline::inline window
