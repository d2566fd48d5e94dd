#include "analysis/thresholds/closed_estimates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/scores/level_words.h"

namespace seamline::analysis {

namespace {

/// Of an interval with an open side, in levels.
std::string open_verdict(const LevelInterval& interval, const LevelAxis& axis) {
  const LevelRange range = range_at(axis, interval);
  if (std::isfinite(range.low)) return "above " + estimated_text(axis, range.low);
  if (std::isfinite(range.high)) return "below " + estimated_text(axis, range.high);
  return fmt::format("not determined: no {} is excluded", level_words(axis).level);
}

}  // namespace

std::string reason_of(const Logistic4Fit& fit, const std::vector<double>& level_x, const LevelAxis& axis) {
  const LevelWords words = level_words(axis);
  const auto text = [&](double x) { return estimated_text(axis, level_at(axis, x)); };
  switch (fit.verdict) {
    case Centre::identified:
      return "";
    case Centre::step: {
      const LevelRange range = range_at(axis, fit.centre_range);
      return fmt::format("a step between {} and {}: the {} tested do not say where",
                         estimated_text(axis, range.low), estimated_text(axis, range.high), words.levels);
    }
    case Centre::straight:
      return "not identified: the fit is all but a straight line";
    case Centre::below_range:
    case Centre::above_range: {
      const bool below = fit.verdict == Centre::below_range;
      const bool lower_level = below == (axis.noticeability == Direction::decreasing);
      return fmt::format("steepest {} {}", lower_level ? "below" : "above",
                         text(below ? level_x.front() : level_x.back()));
    }
    case Centre::not_falling:
      return fmt::format("not identified: noticeability does not {} {}", words.fall, words.with_level);
    case Centre::too_few_levels:
      return fmt::format("not identified: under four {}", words.levels);
  }
  return "";
}

ThresholdEstimate estimate_in(const LevelInterval& range, const Logistic4Fit& fit,
                              const std::vector<double>& level_x, const LevelAxis& axis) {
  ThresholdEstimate estimate;
  const std::string level = level_words(axis).level;
  if (range.low_x == above_every_level)
    estimate.reason = fmt::format("the curve lies above it at every {}", level);
  else if (range.high_x == below_every_level)
    estimate.reason = fmt::format("the curve lies below it at every {}", level);
  else if (range.low_x == range.high_x)
    estimate.level_x = range.low_x;
  else
    estimate.reason = reason_of(fit, level_x, axis);
  return estimate;
}

void keep_closed(ThresholdEstimate& estimate, const LevelInterval& range, const LevelAxis& axis) {
  LevelInterval& ci95 = estimate.ci95;
  ci95.low_x = std::min(ci95.low_x, range.low_x);
  ci95.high_x = std::max(ci95.high_x, range.high_x);
  if (const std::optional<double> length = length_x(ci95)) {
    if (!estimate.level_x) estimate.level_x = (range.low_x + range.high_x) / 2;
    estimate.reason.clear();
  } else if (estimate.level_x) {
    estimate.level_x.reset();
    estimate.reason = open_verdict(ci95, axis);
  }
}

}  // namespace seamline::analysis
