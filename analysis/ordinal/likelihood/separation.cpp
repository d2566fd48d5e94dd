#include "analysis/ordinal/likelihood/separation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "analysis/ordinal/likelihood/row_terms.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// Share of the largest entry of A d below which a negative entry is rounding, or a parameter that is still
/// converging while others diverge.
constexpr double rounding_share = 1e-4;

/// A' A: every finite end with weight 1 and no link between a row's two ends.
Eigen::MatrixXd gram_of_ends(const OrdinalProblem& problem) {
  const Eigen::Index size = problem.cuts() + problem.x.cols();
  const RowRange rows{.begin = 0, .end = problem.rows()};
  RowCurvatures ones{.uu = Eigen::ArrayXd::Zero(problem.rows()),
                     .ul = Eigen::ArrayXd::Zero(problem.rows()),
                     .ll = Eigen::ArrayXd::Zero(problem.rows())};
  for (Eigen::Index row = 0; row < problem.rows(); ++row) {
    const int c = problem.category[row];
    if (c < problem.cuts()) ones.uu[row] = 1;
    if (c > 0) ones.ll[row] = 1;
  }
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(size, size);
  add_hessian(problem, rows, ones, gram);
  return gram;
}

double smallest_slope(const OrdinalProblem& problem, Link link, const Eigen::VectorXd& parameters) {
  const Eigen::VectorXd x_beta = problem.x * parameters.tail(problem.x.cols());
  double smallest = infinity;
  for (Eigen::Index row = 0; row < problem.rows(); ++row) {
    const RowEnds ends = row_ends(problem, parameters, x_beta, row);
    const IntervalTerms terms = interval_terms(link, ends.upper, ends.lower);
    if (std::isfinite(ends.upper)) smallest = std::min(smallest, terms.u);
    if (std::isfinite(ends.lower)) smallest = std::min(smallest, -terms.l);
  }
  return smallest;
}

bool rises_for_ever(const OrdinalProblem& problem, const Eigen::VectorXd& direction) {
  const Eigen::VectorXd x_beta = problem.x * direction.tail(problem.x.cols());
  double least = 0, most = 0;
  for (Eigen::Index row = 0; row < problem.rows(); ++row) {
    const RowEnds ends = row_ends(problem, direction, x_beta, row);
    if (std::isfinite(ends.upper)) {
      least = std::min(least, ends.upper);
      most = std::max(most, ends.upper);
    }
    if (std::isfinite(ends.lower)) {
      least = std::min(least, -ends.lower);
      most = std::max(most, -ends.lower);
    }
  }
  return most > 0 && least >= -rounding_share * most;
}

}  // namespace

Separation look_for_separation(const OrdinalProblem& problem, Link link, const NewtonResult& search) {
  Separation result;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram_of_ends(problem), Eigen::EigenvaluesOnly);
  const double smallest_singular = std::sqrt(std::max(0.0, solver.eigenvalues().minCoeff()));
  if (search.evaluation.gradient.norm() < smallest_slope(problem, link, search.at) * smallest_singular) {
    result.excluded = true;
    return result;
  }
  // Late enough that what converges has converged, early enough that what diverges is not yet lost in
  // rounding: which steps these are depends on the link, so all are tried.
  for (std::size_t span : {1, 4})
    for (std::size_t k = search.path.size(); k-- > span;) {
      const Eigen::VectorXd candidate = search.path[k] - search.path[k - span];
      const double largest = candidate.cwiseAbs().maxCoeff();
      if (!(largest > 0) || !candidate.allFinite() || !rises_for_ever(problem, candidate)) continue;
      result.found = true;
      result.direction = candidate / largest;
      return result;
    }
  return result;
}

}  // namespace seamline::analysis
