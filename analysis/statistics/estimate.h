#pragma once
#include <optional>
#include <string>

#include "support/text/numbers.h"

namespace seamline::analysis {

inline constexpr double above_every_level = infinity;
inline constexpr double below_every_level = -infinity;

/// A confidence interval on log2 width (px). An infinite bound says that the interval is open on that side:
/// the data do not exclude a threshold below the smallest width tested (-inf), or above the largest (+inf).
struct LevelInterval {
  double low_x = below_every_level;
  double high_x = above_every_level;
};

/// A width read off a curve, or the reason why there is none.
struct ThresholdEstimate {
  std::optional<double> level_x;
  std::string reason;  ///< why `level_x` is empty, e.g. "above at every width"
  LevelInterval ci95;
};

}  // namespace seamline::analysis
