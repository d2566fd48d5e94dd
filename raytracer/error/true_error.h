#pragma once
#include <array>
#include <vector>

#include "support/files/image.h"

namespace seamline::renderer {

/// An unbiased reference that is noisy itself: the same picture from two independent halves of its samples,
/// linear radiance (`compose_half` of the `path` estimator's sums).
using ReferenceHalves = std::array<Image, 2>;

/// The error of a finished picture against such a reference, without the reference's noise: the noises of
/// R_a and R_b are independent, so the mean of (F - R_a)(F - R_b) is the mean of (F - R)^2. Estimates without
/// bias, which may therefore be below 0 where the error is small.
struct TrueError {
  double squared = 0;                 ///< over the image
  double squared_standard_error = 0;  ///< from how much the tiles differ
  std::vector<double> tiles = {};     ///< the same as `squared` in each 32 x 32 tile
  /// `squared` with light beyond white that one half of a reference alone has met. Cutting it off leaves the
  /// values that have not met it too dark, and `squared` too large; keeping it makes too small what few
  /// samples say. With enough samples of the reference they are equal. 0 of linear errors.
  double squared_with_rare_light = 0;

  /// Whether the two differ by more than a fifth: `squared` is more the reference's error than the picture's.
  [[nodiscard]] bool reference_is_noisy() const;

  [[nodiscard]] double rmse() const;            ///< 0 where `squared` is below 0
  [[nodiscard]] double standard_error() const;  ///< of `rmse`
  [[nodiscard]] int worst_tile() const;         ///< its index in `tiles`
  [[nodiscard]] double worst_tile_rmse() const;
};

/// In display units (0 to 1): `shown` is what people see, 8-bit sRGB codes made with `exposure_ev`, whose
/// rounding is part of the error. References beyond display white are white. The display curve enters by its
/// slope at F, and for large errors by that of the secant from F to R, so that they are what they are on the
/// display:
///   mean over pixels and channels of slope^2 (F - R_a)(F - R_b).
/// Sizes must agree. `panorama`: rows count by their solid angle.
[[nodiscard]] TrueError true_error(const ByteImage& shown, const ReferenceHalves& reference,
                                   double exposure_ev, bool panorama = false);

/// In linear radiance over the pixels where `mask` is above 0.5.
[[nodiscard]] TrueError true_linear_error(const Image& picture, const ReferenceHalves& reference,
                                          const Image& mask);

}  // namespace seamline::renderer
