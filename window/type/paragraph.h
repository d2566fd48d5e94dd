#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "window/type/font_stack.h"

namespace seamline::inline window {

/// How a text is set.
struct TypeStyle {
  const FontStack* fonts = nullptr;
  double size_px = 22;  ///< from the lowest to the highest letter of the first font
  std::string language = "en";
  bool right_to_left = false;  ///< how paragraphs run, and at which side they stand

  /// Of every font: letters of all have one size.
  [[nodiscard]] double em_px() const;
};

struct PlacedGlyph {
  std::size_t font = 0;  ///< in the stack
  std::uint32_t number = 0;
  std::size_t character = 0;  ///< of its paragraph: the first of those that it stands for
  double x_px = 0, y_px = 0;  ///< from where the line begins, at the foot of its letters
};

/// Glyphs from left to right.
struct TextLine {
  double left_px = 0, top_px = 0;  ///< from the upper left corner of the text
  double width_px = 0;
  std::vector<PlacedGlyph> glyphs = {};
};

struct ArrangedText {
  std::vector<TextLine> lines = {};
  double width_px = 0, height_px = 0;
};

/// Sets a text: each of its lines is a paragraph, ordered by UAX #9, broken by UAX #14 into lines of at most
/// `wrap_px` (0: not broken), and shaped by the fonts. A word that is wider is broken between letters.
/// Paragraphs from right to left stand at the right of `wrap_px`. Throws InputError for a damaged font.
[[nodiscard]] ArrangedText arrange(const TypeStyle& style, std::string_view utf8, double wrap_px);

/// What the glyphs of a line cover, from its upper left corner (left_px, top_px). Left of `-size_px` and
/// right of `most_width_px` nothing is kept.
[[nodiscard]] Coverage draw_line(const TypeStyle& style, const TextLine& line, int most_width_px);

}  // namespace seamline::inline window
