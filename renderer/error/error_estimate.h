#pragma once
#include <array>
#include <vector>

#include "renderer/common/tiles.h"
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

/// The same picture from each half of the samples, filtered and as sampled. Noise: a quarter of the squared
/// difference of the filtered halves. Bias: the product of what the filter changed in one half and in the
/// other; their noises are independent, so the mean of the product is the square of the common change. The
/// display curve enters by its slope.
struct HalfPictures {
  std::array<Image, 2> filtered, sampled;
};
[[nodiscard]] ErrorEstimate estimate_error(const HalfPictures& pictures, double exposure_ev, int threads);

/// Slope of the sRGB curve; 0 where display white is reached.
[[nodiscard]] float display_slope(float linear);

}  // namespace seamline::renderer
