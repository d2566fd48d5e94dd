#include "analysis/statistics/logistic_level.h"

#include <algorithm>
#include <cmath>

namespace seamline::analysis {

WidthInterval logistic_level_range(double level, const Logistic4Fit& fit, std::span<const double> log2_px) {
  if (fit.verdict == Centre::too_few_widths) return {};
  const Logistic4& curve = fit.curve;
  if (value_at(curve, log2_px.back()) > level)
    return {.low_log2_px = above_every_width, .high_log2_px = above_every_width};
  if (value_at(curve, log2_px.front()) < level)
    return {.low_log2_px = below_every_width, .high_log2_px = below_every_width};
  if (fit.verdict == Centre::step) return fit.centre_range;
  if (!(curve.upper > level && level > curve.lower))  // flat at the level, as the largest width it equals
    return {.low_log2_px = log2_px.back(), .high_log2_px = log2_px.back()};
  const double width = std::clamp(
      curve.centre_log2_px + curve.scale_octaves * std::log((curve.upper - level) / (level - curve.lower)),
      log2_px.front(), log2_px.back());
  return {.low_log2_px = width, .high_log2_px = width};
}

WidthEstimate logistic_level_estimate(double level, const Logistic4Fit& fit,
                                      std::span<const double> log2_px) {
  WidthEstimate estimate;
  const WidthInterval range = logistic_level_range(level, fit, log2_px);
  if (range.low_log2_px == above_every_width)
    estimate.reason = "above at every width";
  else if (range.high_log2_px == below_every_width)
    estimate.reason = "below at every width";
  else if (range.low_log2_px == range.high_log2_px)
    estimate.log2_px = range.low_log2_px;
  else
    estimate.reason = reason(fit, log2_px);
  return estimate;
}

}  // namespace seamline::analysis
