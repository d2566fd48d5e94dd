#pragma once
#include <optional>
#include <vector>

#include "analysis/estimate.h"
#include "analysis/logistic4.h"
#include "analysis/resampling.h"

namespace seamline {

/// The 95 % interval of the width where the fitted logistic equals a level, by inverting the score test of
/// `level_interval` with the logistic g in place of the isotonic fit:
///
///     T(w) = (g(w) - level) / s0(w)   against Student's t with n - 1 degrees of freedom
///
/// To first order g(w) is a weighted sum of the means, with weights h(w) = J (J' J)^-1 j(w), where J holds
/// the derivatives of the curve by its four parameters at the widths tested and j(w) those at w. s0(w)^2 = h'
/// S0 h, S0 the covariance of the means with each variance read (`VarianceFunction`) where the curve would be
/// if it were at the level at w. None when the fit does not say where the curve is steep (a step, a straight
/// line, no fall, too few widths), so that the derivatives do not determine the weights. `people` is at
/// least 2.
[[nodiscard]] std::optional<WidthInterval> logistic_level_interval(double level, const Logistic4Fit& fit,
                                                                   const std::vector<double>& log2_px,
                                                                   const MeanVector& means, int people);

}  // namespace seamline
