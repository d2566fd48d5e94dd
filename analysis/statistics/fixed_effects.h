#pragma once
#include <Eigen/Core>
#include <vector>

namespace seamline::analysis {

/// y = X b + effect of its row + effect of its column + error: answers of people (rows) to stimuli (columns).
struct TwoWayData {
  std::vector<int> person = {};    ///< 0..people - 1, one an answer
  std::vector<int> stimulus = {};  ///< 0..stimuli - 1
  Eigen::VectorXd y = {};
  Eigen::MatrixXd x = {};  ///< answers x coefficients
  int people = 0, stimuli = 0;
};

struct TwoWayFit {
  bool determined = false;  ///< X differs beside the effects; else there are no numbers
  Eigen::VectorXd b;
  /// The same without each person, a row each: for the jackknife.
  Eigen::MatrixXd without;
  /// Covariance over people by the jackknife with effects taken out once: n / (n - 1) sum (b_i - mean) (b_i -
  /// mean)', which is (n - 1) / n sum for a person's distance from the means of the others.
  Eigen::MatrixXd covariance;
};

/// Takes both kinds of effects out of every column by turns until nothing changes (Frisch, Waugh and Lovell),
/// then least squares. Of columns whose sum is constant (parts of a whole) it takes the shortest b.
[[nodiscard]] TwoWayFit fit_two_way(TwoWayData data);

/// What is left of y when both kinds of effects are taken out.
[[nodiscard]] Eigen::MatrixXd without_effects(const TwoWayData& data, Eigen::MatrixXd columns);

}  // namespace seamline::analysis
