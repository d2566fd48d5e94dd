#pragma once
#include <functional>

#include "analysis/psychometric/intervals/bootstrap_intervals.h"
#include "analysis/psychometric/intervals/fit_intervals.h"
#include "analysis/psychometric/likelihood/psychometric_fit.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/stability_case.h"

namespace seamline::stability {

/// How a fit's threshold gets its interval; the product's is `threshold_interval`, the profile likelihood.
using IntervalRule = std::function<Interval(const PsychometricFit& fit)>;
[[nodiscard]] Interval interval_as_product(const PsychometricFit& fit);

/// A step: the likelihood is flat in the threshold, so its curvature says nothing. The interval must hold
/// every threshold between the two levels, and the variance by Fisher's information must be infinite. Counts
/// what is otherwise.
[[nodiscard]] Finding try_singular_information(const IntervalRule& rule = interval_as_product);

/// A maximum at the bound of the lapse rate, where the likelihood still rises: the interval must hold the
/// planted threshold of 500 px and be finite. Counts what is otherwise.
[[nodiscard]] Finding try_maximum_at_bound(const IntervalRule& rule = interval_as_product);

/// How a fit is bootstrapped; the product's is `bootstrap_intervals`.
using BootstrapRule =
    std::function<BootstrapIntervals(const PsychometricFit& fit, const BootstrapRequest& request)>;

/// Two answers a level: most resamples are steps or have no threshold within reach. None may be dropped: the
/// interval must hold all of the step's own range and be open where a fortieth of the replicates has no
/// finite one. Counts what is otherwise.
[[nodiscard]] Finding try_degenerate_resamples(const BootstrapRule& rule = bootstrap_intervals);

/// 60 answers a level of seven, right at 256 px as often as a function between its levels: most resamples are
/// steps through a level. The interval must hold the estimate, end at no tested level, and be no longer than
/// 1.3 times the profile's. Counts what is otherwise.
[[nodiscard]] Finding try_steps_through_levels(const BootstrapRule& rule = bootstrap_intervals);

/// Log-likelihood terms of answers whose probability is 1e-130 to 1 - 1e-16, and sigmoids at -1e308 to 1e308:
/// largest deviation from the exact values; NaN when one is no number.
[[nodiscard]] Finding try_extreme_probabilities();

}  // namespace seamline::stability
