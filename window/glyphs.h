#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace seamline::inline window {

/// The shape of one character at one size. Rows from the top; empty for a space.
struct Glyph {
  char32_t character = 0;
  int width_px = 0, height_px = 0;
  int left_px = 0, top_px = 0;  ///< of the shape, from the pen at the top of the line; down is positive
  int advance_px = 0;           ///< of the pen
  std::vector<std::uint8_t> coverage;  ///< height_px * width_px, 255: inside
};

/// The shapes of those characters that the font has, in ascending order, at a size from 4 to 1024 px between
/// highest and lowest letter. `bytes` are a TrueType or OpenType file that anybody may have sent, `file` its
/// name for complaints. Throws InputError when it is another file, is damaged where these shapes are, or has
/// shapes that no text consists of (larger than `largest_shape_em`).
[[nodiscard]] std::vector<Glyph> glyphs_of(std::string_view bytes, const std::string& file,
                                           std::u32string characters, int size_px);

/// Fonts of all Chinese characters have 20 MB.
inline constexpr std::int64_t largest_font_bytes = std::int64_t{64} << 20;

/// No letter is wider, higher, farther from its line or from the next letter, in sizes of the type.
inline constexpr int largest_shape_em = 8;

}  // namespace seamline::inline window
