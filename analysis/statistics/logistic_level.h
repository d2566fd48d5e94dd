#pragma once
#include <span>
#include <vector>

#include "analysis/statistics/estimate.h"
#include "analysis/statistics/logistic4.h"
#include "analysis/statistics/resampling.h"

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

/// The 95 % interval of the width where the least-squares logistic equals a level, by inverting a score test
/// at each width w: is the best logistic through the level at w (`fit_through_level`) worse than chance
/// allows?
///
///     T(w) = h' (y - f) / s0(w)   against Student's t with n - 1 degrees of freedom
///
/// y are the means, f the logistic through the level at w, h = J (J' J)^-1 j(w) with the derivatives J of
/// that logistic by its four parameters at the widths tested and j(w) at w, so that h' (y - f) is what the
/// unconstrained curve at w lies above the level, to first order. s0(w)^2 = h' S0 h, S0 the covariance of the
/// means with each variance read (`VarianceFunction`) at f. Everything is taken where the test supposes the
/// truth to be: taken at the unconstrained fit instead, the interval covers 91 to 98 %
/// (documentation/evidence/coverage.md). Open under four widths. `people` is at least 2.
[[nodiscard]] LevelInterval logistic_level_interval(double level, const Logistic4Fit& fit,
                                                    const std::vector<double>& level_x,
                                                    const MeanVector& means, int people);

}  // namespace seamline::analysis
