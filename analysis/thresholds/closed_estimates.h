#pragma once
#include <string>
#include <vector>

#include "analysis/scores/level_axis.h"
#include "analysis/statistics/logistic4.h"

namespace seamline::analysis {

/// What a curve alone says of a place on its axis, in a width or in words: a point is an estimate; both ends
/// beyond the same side are "the curve lies above it at every width"; a longer range has the reason of the
/// fit.
[[nodiscard]] ThresholdEstimate estimate_in(const LevelInterval& range, const Logistic4Fit& fit,
                                            const std::vector<double>& level_x, const LevelAxis& axis);

/// Why a logistic does not say where its centre is, or where it crosses; empty when it does.
[[nodiscard]] std::string reason_of(const Logistic4Fit& fit, const std::vector<double>& level_x,
                                    const LevelAxis& axis);

/// The rule of all of `analyze`, as of `fit`: there is an estimate exactly where the 95 % interval is closed,
/// and the interval holds it. `range` is where the curve itself puts the threshold: the interval grows to
/// hold it. Of a range that the interval closes in (a step between two widths) the estimate is the middle.
/// Where a side is open the estimate becomes a verdict in words: "above 512", "not determined: no width is
/// excluded".
void keep_closed(ThresholdEstimate& estimate, const LevelInterval& range, const LevelAxis& axis);

}  // namespace seamline::analysis
