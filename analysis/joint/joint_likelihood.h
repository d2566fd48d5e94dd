#pragma once
#include <Eigen/Core>

#include "analysis/joint/joint_model.h"
#include "analysis/ordinal/likelihood/newton.h"

namespace seamline::analysis {

/// Counts of one person or of all: what the likelihood of the joint model needs.
struct JointCounts {
  Eigen::VectorXd cells;       ///< cells x 2K, as a row of `JointData::answers`
  Eigen::VectorXd references;  ///< K
};

[[nodiscard]] JointCounts all_counts(const JointData& data);
[[nodiscard]] JointCounts person_counts(const JointData& data, Eigen::Index person);

/// The log likelihood without multinomial coefficients, sum over outcomes of n log P, with exact gradient and
/// Hessian.
[[nodiscard]] Evaluation joint_likelihood(const JointModel& model, const JointCounts& counts,
                                          const Eigen::VectorXd& theta);
[[nodiscard]] double joint_log_likelihood(const JointModel& model, const JointCounts& counts,
                                          const Eigen::VectorXd& theta);

/// Derivatives of the log probability of each outcome: parameters x (cells x 2K), columns as
/// `JointData::answers`. Its product with a person's counts is the gradient of their likelihood, references
/// apart.
[[nodiscard]] Eigen::MatrixXd outcome_scores(const JointModel& model, const Eigen::VectorXd& theta);

/// The gradient of everybody's own likelihood at one theta: people x parameters. One matrix product, however
/// many people there are.
[[nodiscard]] Eigen::MatrixXd person_scores(const JointModel& model, const JointData& data,
                                            const Eigen::VectorXd& theta);

/// Weak penalties, one for each coordinate, so that a maximum exists whatever the answers are. Quadratic,
/// -(v - centre)^2 / (2 sd^2):
///
///     m: middle of the levels, sd twice their range     log s: log(range / 7), sd 1.5     l: -1, sd 1.5
///     t_2: 0, sd 4     log(t_k - t_{k-1}): 0, sd 1.5     log rho: 0, sd 1
///
/// and half an answer for each guess rating, 0.5 log g(r).
[[nodiscard]] Evaluation joint_penalty(const JointModel& model, const Eigen::VectorXd& theta);

/// Where the penalties of all but the guess ratings are 0.
[[nodiscard]] Eigen::VectorXd penalty_centre(const JointModel& model);

}  // namespace seamline::analysis
