#include "analysis/ordinal/likelihood/robust_covariance.h"

#include <Eigen/Cholesky>

namespace seamline::analysis {

Eigen::MatrixXd jackknife_covariance(const std::vector<ParticipantPart>& parts) {
  if (parts.size() < 3) return {};
  const Eigen::Index size = parts.front().part.gradient.size();
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(size, size);
  for (const ParticipantPart& one : parts) hessian += one.part.hessian;
  Eigen::MatrixXd moved(size, static_cast<Eigen::Index>(parts.size()));
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Eigen::LLT<Eigen::MatrixXd> factor(parts[p].part.hessian - hessian);
    // A tiny pivot is rounding: the others say nothing about some direction.
    if (factor.info() != Eigen::Success ||
        factor.matrixLLT().diagonal().cwiseAbs2().minCoeff() < 1e-9 * -hessian.diagonal().maxCoeff())
      return {};
    moved.col(static_cast<Eigen::Index>(p)) = -factor.solve(parts[p].part.gradient);
  }
  const auto n = static_cast<double>(parts.size());
  const Eigen::VectorXd mean = moved.rowwise().mean();
  moved.colwise() -= mean;
  return (n - 1) / n * (moved * moved.transpose());
}

}  // namespace seamline::analysis
