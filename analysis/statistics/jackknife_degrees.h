#pragma once
#include <Eigen/Core>
#include <vector>

namespace seamline::analysis {

/// Degrees of freedom of the jackknife's variance of one number, of which `values` are those without each
/// person. With v_g the sum of squares about the mean of the n_g people of group g, and k_g their excess
/// kurtosis, 0 where it is negative, those whose chi-square has the variance of the estimated one
/// (Satterthwaite's way; Welch's where values are normal):
///
///     (sum v_g)^2 / sum( v_g^2 (1 / (n_g - 1) + k_g / (2 n_g)) ),    at least 2
///
/// Where one or two people carry a number, n - 1 would promise too much. `group_of` is one number a person,
/// from 0; empty: all are of one group.
[[nodiscard]] double jackknife_degrees(const Eigen::VectorXd& values, const std::vector<int>& group_of = {});

}  // namespace seamline::analysis
