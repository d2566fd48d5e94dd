#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/joint/joint_fit.h"
#include "analysis/statistics/estimate.h"

namespace seamline::analysis {

/// Threshold m of one person on one curve, partially pooled.
struct PersonThreshold {
  Eigen::Index person = 0;  ///< row of the data
  int curve = 0;
  double x = 0;        ///< on the axis
  LevelInterval ci95;  ///< of the normal approximation to what is known of the person
  double answers = 0;  ///< of the person on the curve; 0: known from the other curves and people alone
};

/// How people differ: the threshold of person i on curve c is m_c + u_i + v_ic with u ~ Normal(0, shift_sd^2)
/// and v ~ Normal(0, curve_sd^2). As F is normal, a person's own curve is steeper than the group's:
/// own scale^2 = s^2 - shift_sd^2 - curve_sd^2.
struct JointPeople {
  double shift_sd = 0, curve_sd = 0;  ///< units of the axis
  Eigen::VectorXd own_theta;          ///< the fit's, with the scales of one person instead of the group's
  std::vector<PersonThreshold> thresholds;  ///< people in order, curves running fastest
};

/// Empirical Bayes: each person's thresholds by the Laplace approximation, the two standard deviations where
/// they reproduce themselves as the mean square of what is known of people (EM, Dempster, Laird and Rubin
/// 1977), of at most `many_people` people. `fit` has numbers.
[[nodiscard]] JointPeople joint_people(const JointFit& fit, const JointData& data);

}  // namespace seamline::analysis
