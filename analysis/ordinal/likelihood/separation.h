#pragma once
#include <Eigen/Core>

#include "analysis/ordinal/likelihood/link.h"
#include "analysis/ordinal/likelihood/newton.h"
#include "analysis/ordinal/likelihood/ordinal_data.h"

namespace seamline::analysis {

/// Whether the fixed effects have a maximum-likelihood estimate. With a row a of A for each finite end of
/// each observation (d end / d parameters, the sign such that moving along it raises P), there is none when
/// some direction d has A d >= 0 and A d != 0 (Albert and Anderson 1984 for the logistic regression): the
/// likelihood rises for ever along d. The same direction does so for every value of the participants'
/// effects, so the verdict holds for the mixed model too.
struct Separation {
  bool found = false;
  bool excluded = false;      ///< proved that there is none; neither: not decided
  Eigen::VectorXd direction;  ///< in the problem's own units, largest entry 1; empty when not found
};

/// Reads both off the end of a Newton search of `fixed_likelihood`.
///
/// Proof that there is none: the gradient is A' lambda with lambda > 0 (the slopes of log P in the ends). For
/// any d of length 1 with A d >= 0, gradient . d = lambda . A d >= min(lambda) |A d|_2 >= min(lambda)
/// sigma_min(A). So a gradient shorter than that excludes every such d.
/// Proof that there is one: a direction in which the search was moving, if A d >= 0 but for rounding.
[[nodiscard]] Separation look_for_separation(const OrdinalProblem& problem, Link link,
                                             const NewtonResult& search);

}  // namespace seamline::analysis
