#include "analysis/joint/joint_jackknife.h"

#include <Eigen/Cholesky>

#include "support/running/parallel.h"

namespace seamline::analysis {

namespace {

/// From so many people on one Newton step towards the maximum without a person is as good as the maximum.
constexpr int most_people_climbed = 200;

/// One Newton step towards the maximum without a person, by the curvature of all: also where no search
/// converges.
Eigen::VectorXd step_without(const JointFit& fit, const JointCounts& own) {
  const Eigen::VectorXd gradient = -joint_likelihood(fit.model, own, fit.theta).gradient;
  const Eigen::MatrixXd curvature = -fit.hessian;
  return fit.theta + curvature.llt().solve(gradient);
}

/// `step_without` of everybody.
Eigen::MatrixXd steps_without(const JointFit& fit, const JointData& data) {
  const Eigen::MatrixXd curvature = -fit.hessian;
  const Eigen::MatrixXd steps = curvature.llt().solve(-person_scores(fit.model, data, fit.theta).transpose());
  return (steps.colwise() + fit.theta).transpose();
}

}  // namespace

JointJackknife leave_people_out(const JointFit& fit, const JointData& data, int threads) {
  const auto people = static_cast<int>(data.people.size());
  JointJackknife left{.theta = {}, .covariance = {}};
  if (people > most_people_climbed) {
    left.theta = steps_without(fit, data);
  } else {
    left.theta.resize(people, fit.theta.size());
    const JointCounts all = all_counts(data);
    run_parallel(people, threads, [&](int p) {
      const JointCounts own = person_counts(data, p);
      const JointCounts others{.cells = all.cells - own.cells, .references = all.references - own.references};
      const std::optional<Eigen::VectorXd> without = climb_joint(fit.model, others, fit.theta);
      left.theta.row(p) = (without ? *without : step_without(fit, own)).transpose();
    });
  }
  const Eigen::MatrixXd away = left.theta.rowwise() - left.theta.colwise().mean();
  left.covariance = (people - 1.0) / people * away.transpose() * away;
  return left;
}

}  // namespace seamline::analysis
