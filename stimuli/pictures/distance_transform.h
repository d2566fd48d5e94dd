#pragma once
#include <cstdint>
#include <vector>

namespace seamline::inline stimuli {

/// Some of a picture's pixels: a byte each, rows from the top, 0 where a pixel is left out.
struct PixelSet {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> values;
};

/// For each pixel of the set the square of the Euclidean distance, in pixels between centres, to the nearest
/// pixel left out; 0 for those. Outside the picture every pixel is left out. Exact, in time linear in the
/// pixels: the lower envelope of parabolas, rows after columns (Felzenszwalb and Huttenlocher, "Distance
/// Transforms of Sampled Functions", Theory of Computing 8, 2012).
[[nodiscard]] std::vector<std::int64_t> squared_distances(const PixelSet& set);

/// The diameter in pixels of the largest disc that lies in the set; 0 when no pixel does. Each pixel is taken
/// as 2 x 2 half pixels, and the diameter is the largest distance of one of them, in half pixels, to the
/// nearest half pixel left out: a band of w whole pixels along an axis has exactly w,
/// other shapes their diameter to about a pixel.
[[nodiscard]] double widest_band_px(const PixelSet& set);

}  // namespace seamline::inline stimuli
