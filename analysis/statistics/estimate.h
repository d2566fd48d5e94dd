#pragma once
#include <optional>

#include "stimuli/definition/methods/no_threshold.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

inline constexpr double above_every_level = infinity;
inline constexpr double below_every_level = -infinity;

/// Of every confidence interval of a threshold.
inline constexpr double confidence = 0.95;

/// A confidence interval on log2 width (px). An infinite bound says that the interval is open on that side:
/// the data do not exclude a threshold below the smallest width tested (-inf), or above the largest (+inf).
struct LevelInterval {
  double low_x = below_every_level;
  double high_x = above_every_level;
};

/// How much further one end of an interval lies than another. Two ends that are open on the same side have no
/// distance (infinity less infinity): that is a fault of who asks, and throws std::logic_error.
[[nodiscard]] double distance_between(double end_x, double other_end_x);

/// Length of an interval, octaves where x is log2 width; none where a side is open.
[[nodiscard]] std::optional<double> length_x(const LevelInterval& interval);

/// A width read off a curve, or the reason why there is none.
struct ThresholdEstimate {
  std::optional<double> level_x;
  std::optional<NoThreshold> reason;  ///< why `level_x` is empty; `reason_text` has its sentence
  LevelInterval ci95;
  LevelInterval steepest =
      {};  ///< of what is said of a step and beside the levels: where the curve is steepest
};

}  // namespace seamline::analysis
