#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace seamline::inline window {

/// How much of each pixel letters cover. Rows from the top; empty for a space.
struct Coverage {
  int left_px = 0, top_px = 0;  ///< of the upper left corner, from where the letters stand; down is positive
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> values = {};  ///< height_px * width_px, 255: inside
};

/// Bytes of a font and what the file is called in complaints.
struct FontBytes {
  std::shared_ptr<const std::string> bytes;
  std::string file;
  bool emboldened = false;  ///< drawn bold though it is not
};

/// Fonts of all Chinese characters have 20 MB.
inline constexpr std::int64_t largest_font_bytes = std::int64_t{64} << 20;

/// No letter is wider, higher, farther from its line or from the next letter, in sizes of the type.
inline constexpr int largest_shape_em = 8;

/// Sizes of the em that letters are drawn at.
inline constexpr double smallest_em_px = 3, largest_em_px = 1024;

/// The outlines of a TrueType or OpenType font that anybody may have sent. Nothing is hinted.
class OutlineFont {
 public:
  /// Throws InputError when the bytes are no such font.
  explicit OutlineFont(FontBytes font);
  ~OutlineFont();
  OutlineFont(OutlineFont&&) noexcept;
  OutlineFont& operator=(OutlineFont&&) noexcept;

  /// From the line that letters stand on to the highest, and from there down to the lowest, in ems.
  [[nodiscard]] double ascent_em() const;
  [[nodiscard]] double height_em() const;

  /// A glyph by its number in the font, moved to the right by a part of a pixel from the place where the pen
  /// stands. Throws InputError when it is damaged or larger than `largest_shape_em`.
  [[nodiscard]] Coverage glyph(std::uint32_t number, double em_px, double right_px) const;
  /// The same without values: where they would be, or a little more.
  [[nodiscard]] Coverage frame(std::uint32_t number, double em_px, double right_px) const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace seamline::inline window
