#include "analysis/statistics/logistic_level.h"

#include <algorithm>
#include <cmath>

namespace seamline::analysis {

LevelInterval logistic_level_range(double level, const Logistic4Fit& fit, std::span<const double> level_x) {
  if (fit.verdict == Centre::too_few_widths) return {};
  const Logistic4& curve = fit.curve;
  if (value_at(curve, level_x.back()) > level)
    return {.low_x = above_every_level, .high_x = above_every_level};
  if (value_at(curve, level_x.front()) < level)
    return {.low_x = below_every_level, .high_x = below_every_level};
  if (fit.verdict == Centre::step) return fit.centre_range;
  if (!(curve.upper > level && level > curve.lower))  // flat at the level, as the largest width it equals
    return {.low_x = level_x.back(), .high_x = level_x.back()};
  const double width = std::clamp(
      curve.centre_x + curve.scale_octaves * std::log((curve.upper - level) / (level - curve.lower)),
      level_x.front(), level_x.back());
  return {.low_x = width, .high_x = width};
}

ThresholdEstimate logistic_level_estimate(double level, const Logistic4Fit& fit,
                                          std::span<const double> level_x) {
  ThresholdEstimate estimate;
  const LevelInterval range = logistic_level_range(level, fit, level_x);
  if (range.low_x == above_every_level)
    estimate.reason = "above at every width";
  else if (range.high_x == below_every_level)
    estimate.reason = "below at every width";
  else if (range.low_x == range.high_x)
    estimate.level_x = range.low_x;
  else
    estimate.reason = reason(fit, level_x);
  return estimate;
}

}  // namespace seamline::analysis
