#include "analysis/ordinal/likelihood/newton.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// Steps are no longer than this in any parameter (which are of the order of 1: columns are scaled).
constexpr double longest_step = 5;
constexpr int most_halvings = 40;
/// Expected gain, as a share of the value, below which the value cannot tell better from worse any more.
constexpr double lost_in_rounding = 1e-11;
/// Expected gain below which nothing can be won.
constexpr double nothing_to_gain = 1e-26;

/// The Newton step, with the curvature's diagonal raised until it is positive definite. Empty when no damping
/// helps.
Eigen::VectorXd step_of(const Evaluation& evaluation) {
  const Eigen::VectorXd diagonal = evaluation.hessian.diagonal().cwiseAbs();
  for (double damping = 0; damping < 1e8; damping = damping == 0 ? 1e-6 : damping * 10) {
    Eigen::MatrixXd curvature = -evaluation.hessian;
    curvature.diagonal() += damping * diagonal;
    const Eigen::LLT<Eigen::MatrixXd> factor(curvature);
    if (factor.info() != Eigen::Success) continue;
    Eigen::VectorXd step = factor.solve(evaluation.gradient);
    if (!step.allFinite()) continue;
    const double longest = step.cwiseAbs().maxCoeff();
    if (longest > longest_step) step *= longest_step / longest;
    return step;
  }
  return {};
}

}  // namespace

NewtonResult maximise(const std::function<Evaluation(const Eigen::VectorXd&)>& function,
                      const Eigen::VectorXd& start, int most_iterations) {
  NewtonResult result{
      .at = start, .evaluation = function(start), .path = {start}, .converged = false, .iterations = 0};
  double last_gain = infinity;
  for (; result.iterations < most_iterations; ++result.iterations) {
    const Evaluation& here = result.evaluation;
    const Eigen::VectorXd step = step_of(here);
    if (step.size() == 0) return result;
    const double gain = 0.5 * here.gradient.dot(step);
    const bool rounding = gain < lost_in_rounding * (1 + std::abs(here.value));
    if (gain < nothing_to_gain || (rounding && !(gain < 0.5 * last_gain))) {
      result.converged = rounding;
      return result;
    }
    last_gain = rounding ? gain : infinity;
    double share = 1;
    Evaluation tried = function(result.at + step);
    for (int halving = 0; !rounding && halving < most_halvings && !(tried.value > here.value); ++halving) {
      share /= 2;
      tried = function(result.at + share * step);
    }
    if (!std::isfinite(tried.value) || (!rounding && !(tried.value > here.value))) return result;
    result.at += share * step;
    result.path.push_back(result.at);
    result.evaluation = std::move(tried);
  }
  return result;
}

}  // namespace seamline::analysis
