#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "raytracer/error/error_estimate.h"

namespace seamline::renderer {

/// What is wrong with a picture, as its own halves of samples show it: five numbers of each pixel and channel
/// in display units, in steps of 1/16384. Two pictures of the same samples are wrong alike where nothing
/// changed, so the error of their difference is found from the difference of their maps.
struct ErrorMap {
  /// The rows that are kept: all of a small picture, and so many of a larger one that a map has no more than
  /// about 270 of them.
  std::vector<int> rows = {};
  int width_px = 0, height_px = 0;  ///< of the picture
  bool wraps = false;               ///< a panorama, whose rows count by their solid angle
  /// The whole less each half, times the root of `unseen_specks`.
  std::array<std::vector<std::int16_t>, 2> off = {};
  std::array<std::vector<std::int16_t>, 2> filtered_by = {};  ///< what the filter changed in each half
  std::vector<std::int16_t> rounded_by = {};                  ///< what rounding to 8 bits changes
};

/// `filtered_more`: what other filters changed in each half, linear radiance; empty pictures: nothing.
[[nodiscard]] ErrorMap error_map(const HalfPictures& pictures, const std::array<Image, 2>& filtered_more,
                                 double exposure_ev, int threads, bool panorama = false);

/// The mean squared error of the change from one picture to the next, display units: with a and b the changes
/// of the two `off`, a^2 + b^2 + ab (see `estimate_error`), the product of the changes of the two
/// `filtered_by` where its mean is above 0, and the square of the change of `rounded_by`. 0 where both are
/// one picture.
[[nodiscard]] double change_error(const ErrorMap& before, const ErrorMap& now);

}  // namespace seamline::renderer
