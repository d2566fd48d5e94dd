#pragma once
#include <span>
#include <vector>

#include "analysis/statistics/estimate.h"
#include "analysis/statistics/logistic4.h"

namespace seamline::analysis {

/// The widths at which a fitted four-parameter logistic y(x) (see `Logistic4`) is at `level`: the parametric
/// counterpart of `largest_x_at`,
///
///     x = centre + scale ln((upper - level) / (level - lower))
///
/// One value, or the two widths tested between which the fit is a step and says no more, or infinite ends:
/// both +inf when the curve is above the level at every width tested, both -inf when it is below, everything
/// when there were too few widths for a fit. Beyond the widths tested the curve is not read: its asymptotes
/// are extrapolations.
[[nodiscard]] LevelInterval logistic_level_range(double level, const Logistic4Fit& fit,
                                                 std::span<const double> level_x);

/// The same as an estimate, with the reason where there is none; its interval is left open.
[[nodiscard]] ThresholdEstimate logistic_level_estimate(double level, const Logistic4Fit& fit,
                                                        std::span<const double> level_x);

}  // namespace seamline::analysis
