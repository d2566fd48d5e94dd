#include "analysis/thresholds/closed_estimates.h"

#include <algorithm>
#include <cmath>

namespace seamline::analysis {

namespace {

/// Of an interval with an open side, in levels.
NoThreshold reason_of_open(const LevelInterval& interval, const LevelAxis& axis) {
  const LevelRange range = range_at(axis, interval);
  if (std::isfinite(range.low)) return NoThreshold::above_level;
  return std::isfinite(range.high) ? NoThreshold::below_level : NoThreshold::any_level;
}

}  // namespace

ThresholdEstimate centre_of(const Logistic4Fit& fit, const std::vector<double>& level_x,
                            const LevelAxis& axis) {
  ThresholdEstimate estimate;
  const auto beside = [&](const LevelInterval& steepest) {
    estimate.steepest = steepest;
    return std::isfinite(range_at(axis, steepest).high) ? NoThreshold::steepest_below
                                                        : NoThreshold::steepest_above;
  };
  switch (fit.verdict) {
    case Centre::identified:
      estimate.level_x = fit.curve.centre_x;
      break;
    case Centre::step:
      estimate.reason = NoThreshold::step;
      estimate.steepest = fit.centre_range;
      break;
    case Centre::straight:
      estimate.reason = NoThreshold::straight;
      break;
    case Centre::below_range:
      estimate.reason = beside({.low_x = below_every_level, .high_x = level_x.front()});
      break;
    case Centre::above_range:
      estimate.reason = beside({.low_x = level_x.back(), .high_x = above_every_level});
      break;
    case Centre::not_falling:
      estimate.reason = NoThreshold::not_falling;
      break;
    case Centre::too_few_levels:
      estimate.reason = NoThreshold::under_four_levels;
      break;
  }
  return estimate;
}

ThresholdEstimate estimate_in(const LevelInterval& range, const Logistic4Fit& fit,
                              const std::vector<double>& level_x, const LevelAxis& axis) {
  ThresholdEstimate estimate;
  if (range.low_x == above_every_level) {
    estimate.reason = NoThreshold::curve_above;
  } else if (range.high_x == below_every_level) {
    estimate.reason = NoThreshold::curve_below;
  } else if (range.low_x == range.high_x) {
    estimate.level_x = range.low_x;
  } else {
    estimate = centre_of(fit, level_x, axis);
    estimate.level_x.reset();
  }
  return estimate;
}

void keep_closed(ThresholdEstimate& estimate, const LevelInterval& range, const LevelAxis& axis) {
  LevelInterval& ci95 = estimate.ci95;
  ci95.low_x = std::min(ci95.low_x, range.low_x);
  ci95.high_x = std::max(ci95.high_x, range.high_x);
  if (const std::optional<double> length = length_x(ci95)) {
    if (!estimate.level_x) estimate.level_x = (range.low_x + range.high_x) / 2;
    estimate.reason.reset();
  } else if (estimate.level_x) {
    estimate.level_x.reset();
    estimate.reason = reason_of_open(ci95, axis);
  }
}

}  // namespace seamline::analysis
