#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "window/type/glyphs.h"

namespace seamline::inline window {

/// A writing system, as its four letters of ISO 15924 in one number (`script("Arab")`).
using Script = std::uint32_t;

[[nodiscard]] constexpr Script script(const char (&letters)[5]) {
  Script number = 0;
  for (int i = 0; i < 4; ++i) number = number << 8U | static_cast<unsigned char>(letters[i]);
  return number;
}

/// The writing system of each character. Spaces, digits, punctuation and marks belong to the letters before
/// them, or else to those that follow; Zyyy where there are none.
[[nodiscard]] std::vector<Script> scripts_of(std::u32string_view text);

/// Whether a character is drawn onto the one before it or joins it, so that both must come from one font.
[[nodiscard]] bool is_joined_to_previous(char32_t character);

/// Part of a text in one direction, one writing system and one font.
struct TextRun {
  std::size_t begin = 0, end = 0;
  bool right_to_left = false;
  Script script = seamline::script("Zyyy");
};

/// A glyph, and how far the pen goes on after it.
struct ShapedGlyph {
  std::uint32_t number = 0;   ///< in its font
  std::size_t character = 0;  ///< the first of those that it stands for
  double advance_px = 0;
  double right_px = 0, down_px = 0;  ///< from the pen
};

/// The part of a font that says how characters become glyphs. The font may be anybody's.
class ShapingFont {
 public:
  explicit ShapingFont(FontBytes font);
  ~ShapingFont();
  ShapingFont(ShapingFont&&) noexcept;
  ShapingFont& operator=(ShapingFont&&) noexcept;

  [[nodiscard]] bool has(char32_t character) const;

  /// The glyphs of a run from left to right. Characters around it decide how its ends join. `language` is a
  /// tag of BCP 47. Throws InputError when the font wants glyphs farther apart than `largest_shape_em`, or
  /// far more of them than there are characters.
  [[nodiscard]] std::vector<ShapedGlyph> shape(std::u32string_view text, const TextRun& run,
                                               const std::string& language, double em_px) const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace seamline::inline window
