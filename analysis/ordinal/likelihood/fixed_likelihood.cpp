#include "analysis/ordinal/likelihood/fixed_likelihood.h"

#include <vector>

#include "analysis/ordinal/likelihood/row_terms.h"
#include "analysis/statistics/distributions.h"
#include "support/running/parallel.h"

namespace seamline::analysis {

namespace {

/// Rows that are summed together. Fixed, so that sums do not depend on threads.
constexpr Eigen::Index chunk_rows = 2048;

Evaluation of_rows(const OrdinalProblem& problem, Link link, const Eigen::VectorXd& parameters,
                   const Eigen::VectorXd& x_beta, const RowRange& rows) {
  const Eigen::Index size = parameters.size();
  Evaluation sum{
      .value = 0, .gradient = Eigen::VectorXd::Zero(size), .hessian = Eigen::MatrixXd::Zero(size, size)};
  RowSlopes slopes{.u = Eigen::ArrayXd(rows.size()), .l = Eigen::ArrayXd(rows.size())};
  RowCurvatures curvatures{.uu = Eigen::ArrayXd(rows.size()),
                           .ul = Eigen::ArrayXd(rows.size()),
                           .ll = Eigen::ArrayXd(rows.size())};
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const RowEnds ends = row_ends(problem, parameters, x_beta, rows.begin + i);
    const IntervalTerms terms = interval_terms(link, ends.upper, ends.lower);
    sum.value += terms.log_p;
    slopes.u[i] = terms.u;
    slopes.l[i] = terms.l;
    curvatures.uu[i] = terms.uu;
    curvatures.ul[i] = terms.ul;
    curvatures.ll[i] = terms.ll;
  }
  add_gradient(problem, rows, slopes, sum.gradient);
  add_hessian(problem, rows, curvatures, sum.hessian);
  return sum;
}

}  // namespace

Evaluation fixed_likelihood(const OrdinalProblem& problem, Link link, const Eigen::VectorXd& parameters,
                            int threads) {
  const Eigen::VectorXd x_beta = problem.x * parameters.segment(problem.cuts(), problem.x.cols());
  const auto chunks = static_cast<int>((problem.rows() + chunk_rows - 1) / chunk_rows);
  std::vector<Evaluation> parts(chunks);
  run_parallel(chunks, threads, [&](int chunk) {
    const Eigen::Index begin = chunk * chunk_rows;
    const RowRange rows{.begin = begin, .end = std::min(problem.rows(), begin + chunk_rows)};
    parts[chunk] = of_rows(problem, link, parameters, x_beta, rows);
  });
  Evaluation sum = std::move(parts.front());
  for (std::size_t chunk = 1; chunk < parts.size(); ++chunk) {
    sum.value += parts[chunk].value;
    sum.gradient += parts[chunk].gradient;
    sum.hessian += parts[chunk].hessian;
  }
  return sum;
}

Eigen::VectorXd null_parameters(const OrdinalProblem& problem, Link link) {
  std::vector<double> count(problem.categories(), 0.0);
  for (const int category : problem.category) count[category] += 1;
  Eigen::VectorXd parameters = Eigen::VectorXd::Zero(problem.cuts() + problem.x.cols());
  double below = 0;
  for (int cut = 0; cut < problem.cuts(); ++cut) {
    below += count[cut];
    const double share = below / static_cast<double>(problem.rows());
    parameters[cut] = link == Link::logit ? logistic_quantile(share) : normal_quantile(share);
  }
  return parameters;
}

}  // namespace seamline::analysis
