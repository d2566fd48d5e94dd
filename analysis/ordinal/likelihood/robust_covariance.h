#pragma once
#include <Eigen/Core>
#include <vector>

#include "analysis/ordinal/likelihood/marginal_likelihood.h"

namespace seamline::analysis {

/// Covariance of the parameters by the jackknife over participants, each left-out estimate by one Newton step
/// from the maximum (Bell and McCaffrey 2002: CR3, the cautious one of the cluster-robust estimators):
///
///     theta_(p) - theta = (H - H_p)^{-1} g_p,     V = (n - 1) / n sum_p (theta_(p) - mean)(...)'
///
/// g_p, H_p are the gradient and Hessian of participant p's part, H their sum. Unlike the inverse Hessian it
/// stays right when participants differ in more than their level (in the slope over width, in how much one
/// artifact disturbs them), or when the link is not quite right. Empty with fewer than three participants or
/// when H - H_p is not negative definite: the fit hangs on participant p.
[[nodiscard]] Eigen::MatrixXd jackknife_covariance(const std::vector<ParticipantPart>& parts);

}  // namespace seamline::analysis
