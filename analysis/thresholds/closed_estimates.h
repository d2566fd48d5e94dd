#pragma once
#include <string>
#include <vector>

#include "analysis/scores/level_axis.h"
#include "analysis/statistics/logistic4.h"

namespace seamline::analysis {

/// What a curve alone says of a place on its axis: a point is an estimate; both ends beyond the same side are
/// "the curve lies above it at every width"; a longer range has the reason of the fit.
[[nodiscard]] ThresholdEstimate estimate_in(const LevelInterval& range, const Logistic4Fit& fit,
                                            const std::vector<double>& level_x, const LevelAxis& axis);

/// The centre of a logistic, or why it does not say where that is.
[[nodiscard]] ThresholdEstimate centre_of(const Logistic4Fit& fit, const std::vector<double>& level_x,
                                          const LevelAxis& axis);

/// The rule of all of `analyze`, as of `fit`: there is an estimate exactly where the 95 % interval is closed,
/// and the interval holds it. `range` is where the curve itself puts the threshold: the interval grows to
/// hold it. Of a range that the interval closes in (a step between two widths) the estimate is the middle.
/// Where a side is open a reason takes the estimate's place: "above 512", "not determined: no width is
/// excluded".
void keep_closed(ThresholdEstimate& estimate, const LevelInterval& range, const LevelAxis& axis);

}  // namespace seamline::analysis
