#pragma once
#include "analysis/joint/joint_fit.h"
#include "analysis/joint/joint_jackknife.h"

namespace seamline::analysis {

/// The joint model of answers at levels that the answers placed (QUEST+). People with large thresholds are
/// then asked at other levels than those with small ones, so the counts of all people together say nothing of
/// their mean curve. What holds is the likelihood of each person, given their own threshold: the placement
/// depends on the person's earlier answers alone. With p a person, c a curve, y their answers there, and all
/// but m of JointCurve one person's own,
///
///     log L = sum over p and c of log( integral P(y_pc | m_c + w) Normal(w; 0, sd^2) dw )
///
/// by 41 equal steps from -5 to 5 sd. A person's curves are taken one by one, as if their shifts were
/// independent; that costs precision and no bias, and intervals over participants count it.

/// `JointFit` of a model `between_people`: its places and means are over people (joint_quantities.h).
/// Verdicts are those of `fit_joint`.
[[nodiscard]] JointFit fit_placed(const JointData& data, const JointSharing& sharing = {});

/// Of the likelihood at theta: minus its Hessian, and the gradient of each person's.
struct PeopleScores {
  Eigen::MatrixXd information;
  Eigen::MatrixXd scores;  ///< people x parameters
};
/// `model` is `between_people`.
[[nodiscard]] PeopleScores placed_scores(const JointModel& model, const JointData& data,
                                         const Eigen::VectorXd& theta);

/// As `leave_people_out`, of a fit by `fit_placed`: the maximum without each person of up to 20, one Newton
/// step by the curvature of the others from there on.
[[nodiscard]] JointJackknife leave_placed_people_out(const JointFit& fit, const JointData& data,
                                                     int threads = 0);

}  // namespace seamline::analysis
