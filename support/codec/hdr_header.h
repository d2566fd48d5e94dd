#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>

namespace seamline {

/// What the text before a Radiance picture's pixels says (Ward, "The RADIANCE Picture File Format").
struct HdrHeader {
  bool xyz = false;     ///< pixels are CIE XYZ in place of red, green and blue
  double exposure = 1;  ///< the product of all EXPOSURE lines: pixels are radiance times this
  std::array<double, 3> colour_correction{1, 1, 1};    ///< likewise of COLORCORR, for each channel
  std::optional<std::array<float, 8>> primaries = {};  ///< x and y of red, green, blue and white
  int lines = 0, line_px = 0;                          ///< as the file stores them
  /// As EXIF numbers it: which sides of the picture the file's first line and first column are.
  int orientation = 1;
  std::size_t pixels_at = 0;  ///< bytes before the pixels
};

/// Reads it. Throws InputError naming the file at a header that ends early, has no size, another pixel
/// format, or an exposure that is no number above 0.
[[nodiscard]] HdrHeader read_hdr_header(const std::filesystem::path& path);

}  // namespace seamline
