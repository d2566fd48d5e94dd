#pragma once
#include <Eigen/Core>
#include <limits>
#include <vector>

namespace seamline::analysis {

/// The distribution of max_j |T_j| for a multivariate t (normal: infinite degrees of freedom) with a given
/// correlation, which may be singular: all pairs of k groups span k - 1 dimensions only. It is what
/// single-step adjustment reads (Hothorn, Bretz and Westfall 2008).
///
/// T = R L w with w uniform on the sphere and R the length, L L' the correlation. Given w the length is
/// integrated exactly, P(R > c / max_j |L_j w|), where R^2 / dimension is F distributed; over w the mean is
/// taken on a fixed lattice. So the same input gives the same bits, and small tails are as exact as large
/// ones. Absolute error of a probability near 0.05: under 1e-3 (measured against Tukey's and Dunnett's
/// tables).
class MaxAbsT {
 public:
  /// `correlation` has ones on its diagonal; `degrees_of_freedom` may be infinite.
  MaxAbsT(const Eigen::MatrixXd& correlation, double degrees_of_freedom);

  /// P(max |T_j| > t): the adjusted p of a contrast whose |t| is `t`.
  [[nodiscard]] double tail(double t) const;

  /// The t whose tail is `probability`: simultaneous intervals are estimate -+ t se.
  [[nodiscard]] double critical(double probability) const;

 private:
  double degrees_of_freedom_;
  Eigen::Index dimension_ = 0;
  Eigen::Index count_ = 0;
  std::vector<double> reach_;  ///< means of max_j |L_j w| over equal shares of the sphere, rising
};

/// P(|T| > t) for Student's t, or the normal when the degrees of freedom are infinite.
[[nodiscard]] double two_sided_tail(double t, double degrees_of_freedom);

/// The t with P(|T| > t) = probability.
[[nodiscard]] double two_sided_critical(double probability, double degrees_of_freedom);

}  // namespace seamline::analysis
