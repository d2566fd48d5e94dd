#pragma once
#include <optional>
#include <string>

#include "support/text/numbers.h"

namespace seamline::analysis {

inline constexpr double above_every_width = infinity;
inline constexpr double below_every_width = -infinity;

/// A confidence interval on log2 width (px). An infinite bound says that the interval is open on that side:
/// the data do not exclude a threshold below the smallest width tested (-inf), or above the largest (+inf).
struct WidthInterval {
  double low_log2_px = below_every_width;
  double high_log2_px = above_every_width;
};

/// A width read off a curve, or the reason why there is none.
struct WidthEstimate {
  std::optional<double> log2_px;
  std::string reason;  ///< why `log2_px` is empty, e.g. "above at every width"
  WidthInterval ci95;
};

}  // namespace seamline::analysis
