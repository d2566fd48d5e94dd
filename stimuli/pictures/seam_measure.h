#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "stimuli/pictures/distance_transform.h"
#include "support/files/image.h"

namespace seamline::inline stimuli {

// How large the place is where a stimulus differs from its reference, in 8-bit codes (steps of 255).

/// A seam is measured where the difference exceeds so many steps beyond noise.
inline constexpr std::array<int, 3> seam_steps = {2, 4, 8};
/// Standard deviations of the noise that are no difference.
inline constexpr double seam_noise_deviations = 3;
/// Noise is estimated in squares of this side.
inline constexpr int seam_tile_px = 32;

/// The signed difference of two pictures, stimulus less reference, -255 to 255; channels interleaved.
struct SignedDifference {
  int width_px = 0, height_px = 0, channels = 0;
  std::vector<std::int16_t> steps;
};

/// Pictures of one shape.
[[nodiscard]] SignedDifference signed_difference(const ByteImage& stimulus, const ByteImage& reference);

/// The standard deviation of the noise in tiles, in steps: channels interleaved, tiles in rows from the top.
struct NoiseTiles {
  int columns = 0, rows = 0, channels = 0;
  std::vector<double> deviation_steps;

  /// Of the tile that a pixel lies in.
  [[nodiscard]] double at(int x, int y, int channel) const;
};

/// Noise of a difference in tiles of 32 x 32 pixels (the last of a row or column has 16 to 47): Immerkaer's
/// ("Fast noise variance estimation", Computer Vision and Image Understanding 64, 1996) mask
/// [1 -2 1; -2 4 -2; 1 -2 1] / 6 applied to each channel, which takes away what is flat, sloped or a straight
/// edge along an axis and leaves the standard deviation of white noise as it is; then 1.4826 times the median
/// of its absolute value, so that the other edges of an artifact do not count as noise. The responses are
/// sixths of a step; within the sixth that the median falls into, it is interpolated. 0 where half of the
/// responses are 0, and in pictures under 3 pixels. Noise that neighbours share is underestimated.
[[nodiscard]] NoiseTiles noise_tiles(const SignedDifference& difference);

/// Where the difference exceeds `step` beyond noise. A pixel is judged by d, the difference of the channel in
/// which it is largest, and exceeds when |d| > step + 3 sigma, sigma that channel's in the pixel's tile. It
/// counts when one of its eight neighbours exceeds as well, with d of the same sign: a place where people see
/// something has more than one pixel, and single ones are what is left of noise (the tail beyond 3 sigma, and
/// rare large differences in tiles where rounding to 8 bits hides all others and sigma is 0).
[[nodiscard]] PixelSet seam_pixels(const SignedDifference& difference, const NoiseTiles& noise, int step);

struct SeamExtent {
  std::int64_t area_px = 0;   ///< pixels that count
  double widest_band_px = 0;  ///< diameter of the largest disc among them
};

struct SeamMeasure {
  std::array<SeamExtent, seam_steps.size()> beyond;  ///< each of `seam_steps`
  double largest_noise_steps = 0;                    ///< standard deviation in the noisiest tile
};

/// The seam of a stimulus, from two pictures of one shape.
[[nodiscard]] SeamMeasure measure_seam(const ByteImage& stimulus, const ByteImage& reference);

}  // namespace seamline::inline stimuli
