#pragma once
#include <compare>
#include <string>

#include "sensors/repair/repaired.h"

namespace seamline::sensors {

/// The median of the measured values in a square window of 2 radius_px + 1 pixels' side, cut at the picture's
/// border; of an even number the lower of the middle two, so that every value of the result was measured.
struct MedianRepair {
  int radius_px = 1;
  bool fills = false;  ///< whether a hole with at least half of its window measured gets a depth

  auto operator<=>(const MedianRepair&) const = default;
};

/// Throws InputError naming `where` unless the radius is 1 to 50.
void require_valid(const MedianRepair& median, const std::string& where);

/// Smooths by the median. The same bytes for any number of threads (0: one for each core). Throws InputError
/// as `require_valid`.
[[nodiscard]] Repaired smooth_by_median(const DepthFrame& measured, const MedianRepair& median,
                                        int threads = 0);

}  // namespace seamline::sensors
