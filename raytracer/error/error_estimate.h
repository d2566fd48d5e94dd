#pragma once
#include <array>
#include <vector>

#include "raytracer/common/tiles.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// The error of a picture as estimated from the picture's own two halves of samples, in display units (0 to
/// 1, after exposure and the sRGB curve), squared.
struct SquaredError {
  double noise = 0;  ///< variance of the mean of the two halves
  double bias = 0;   ///< square of what a filter changes; an estimate without bias, so it may be below 0

  [[nodiscard]] double total() const { return noise + (bias > 0 ? bias : 0); }
};

/// What rounding to 8 bits adds to a squared error: people see rounded pictures.
inline constexpr double rounding_square = 1.0 / (12.0 * 255.0 * 255.0);

struct ErrorEstimate {
  SquaredError image;
  std::vector<SquaredError> tiles;
  std::vector<SquaredError> blocks;         ///< what samples are planned by
  [[nodiscard]] double rmse() const;        ///< over the image: noise, bias and rounding
  [[nodiscard]] double worst_tile() const;  ///< the largest of any tile
};

/// The same picture from each half of the samples, filtered and as sampled, and from all of them.
struct HalfPictures {
  std::array<Image, 2> filtered, sampled;
  Image whole = {};  ///< as it is shown, filtered; empty: the mean of the halves
};
/// Noise: with a and b the whole less each half, as displayed, a^2 + b^2 + ab. Where the picture is the mean
/// of its samples, b = -a, and that is a quarter of the squared difference of the halves. Where it is not
/// (the display curve, white that is reached, a quotient of few samples, a rule for tiny denominators that
/// takes either side) the whole lies off their middle. A bright speck is white in the whole and in the half
/// that has it, so that a = 0 and b^2 is the speck's squared error, of which the difference of the halves is
/// a quarter. Bias: the product of what the filter changed in one half and in the other; their noises are
/// independent, so the mean of the product is the square of the common change. The display curve enters by
/// its slope. `panorama`: rows count by their solid angle.
[[nodiscard]] ErrorEstimate estimate_error(const HalfPictures& pictures, double exposure_ev, int threads,
                                           bool panorama = false);

/// The noise that `estimate_error` finds in a block. `gain`: radiance to display values.
[[nodiscard]] double block_noise(const std::array<Image, 2>& halves, const Image& whole,
                                 const BlockGrid& blocks, int block, float gain);
/// Its bias.
[[nodiscard]] double block_bias(const std::array<Image, 2>& filtered, const std::array<Image, 2>& sampled,
                                const BlockGrid& blocks, int block, float gain);
/// Those of tiles and picture from those of the blocks.
[[nodiscard]] ErrorEstimate error_of_blocks(std::vector<SquaredError> of_blocks, const BlockGrid& blocks);

/// By how much the squared error of pixels with rare bright samples is larger than what those say that have
/// had one. `speck`: what one adds to the whole, in units of display white. When all rates are alike likely
/// (log-uniform, a Poisson number of specks in each half) the true squared error, summed over all pixels, is
/// 0.7, 1.2, 1.9 and 2.7 times that of a^2 + b^2 + ab for specks of 1, 3, 10 and 30: a pixel that will be
/// white one day is dark until its first speck. 1 up to a speck of 2.2: light of rough surfaces has none.
[[nodiscard]] float unseen_specks(float speck);

/// Slope of the sRGB curve; 0 where display white is reached.
[[nodiscard]] float display_slope(float linear);

}  // namespace seamline::renderer
