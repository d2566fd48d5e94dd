#include "analysis/joint/joint_jackknife.h"

#include <Eigen/Cholesky>

#include "support/running/parallel.h"

namespace seamline::analysis {

namespace {

/// The Newton step of the objective without a person; by the whole curvature where theirs leaves none.
Eigen::VectorXd step_without(const Evaluation& rest, const Eigen::MatrixXd& curvature) {
  const Eigen::LLT<Eigen::MatrixXd> own(-rest.hessian);
  if (own.info() == Eigen::Success) {
    Eigen::VectorXd step = own.solve(rest.gradient);
    if (step.allFinite()) return step;
  }
  return curvature.llt().solve(rest.gradient);
}

}  // namespace

JointJackknife leave_people_out(const JointFit& fit, const JointData& data, int threads) {
  const auto people = static_cast<int>(data.people.size());
  JointJackknife left{.theta = Eigen::MatrixXd(people, fit.theta.size()), .covariance = {}};
  const JointCounts all = all_counts(data);
  const Eigen::MatrixXd curvature = -fit.hessian;
  run_parallel(people, threads, [&](int p) {
    const JointCounts own = person_counts(data, p);
    const Evaluation of_person = joint_likelihood(fit.model, own, fit.theta);
    Evaluation rest{.value = 0, .gradient = -of_person.gradient, .hessian = fit.hessian - of_person.hessian};
    left.theta.row(p) = (fit.theta + step_without(rest, curvature)).transpose();
  });
  const Eigen::MatrixXd away = left.theta.rowwise() - left.theta.colwise().mean();
  left.covariance = (people - 1.0) / people * away.transpose() * away;
  return left;
}

}  // namespace seamline::analysis
