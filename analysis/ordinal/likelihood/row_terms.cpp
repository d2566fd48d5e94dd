#include "analysis/ordinal/likelihood/row_terms.h"

#include "support/text/numbers.h"

namespace seamline::analysis {

RowEnds row_ends(const OrdinalProblem& problem, const Eigen::VectorXd& parameters,
                 const Eigen::VectorXd& x_beta, Eigen::Index row) {
  const int c = problem.category[row];
  return {.upper = c < problem.cuts() ? parameters[c] - x_beta[row] : infinity,
          .lower = c > 0 ? parameters[c - 1] - x_beta[row] : -infinity};
}

void add_gradient(const OrdinalProblem& problem, const RowRange& rows, const RowSlopes& slopes,
                  Eigen::VectorXd& gradient) {
  const int cuts = problem.cuts();
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const int c = problem.category[rows.begin + i];
    if (c < cuts) gradient[c] += slopes.u[i];
    if (c > 0) gradient[c - 1] += slopes.l[i];
  }
  gradient.segment(cuts, problem.x.cols()) -=
      problem.x.middleRows(rows.begin, rows.size()).transpose() * (slopes.u + slopes.l).matrix();
}

void add_hessian(const OrdinalProblem& problem, const RowRange& rows, const RowCurvatures& curvatures,
                 Eigen::MatrixXd& hessian) {
  const int cuts = problem.cuts();
  const Eigen::Index columns = problem.x.cols();
  Eigen::MatrixXd by_cut = Eigen::MatrixXd::Zero(rows.size(), cuts);  // d2 / d cut d eta of each row
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const int c = problem.category[rows.begin + i];
    if (c < cuts) {
      hessian(c, c) += curvatures.uu[i];
      by_cut(i, c) -= curvatures.uu[i] + curvatures.ul[i];
    }
    if (c > 0) {
      hessian(c - 1, c - 1) += curvatures.ll[i];
      by_cut(i, c - 1) -= curvatures.ul[i] + curvatures.ll[i];
    }
    if (c > 0 && c < cuts) {
      hessian(c, c - 1) += curvatures.ul[i];
      hessian(c - 1, c) += curvatures.ul[i];
    }
  }
  if (columns == 0) return;
  const auto x = problem.x.middleRows(rows.begin, rows.size());
  const Eigen::MatrixXd mixed = by_cut.transpose() * x;
  hessian.block(0, cuts, cuts, columns) += mixed;
  hessian.block(cuts, 0, columns, cuts) += mixed.transpose();
  const Eigen::ArrayXd ss = curvatures.uu + 2 * curvatures.ul + curvatures.ll;
  hessian.block(cuts, cuts, columns, columns) += x.transpose() * (x.array().colwise() * ss).matrix();
}

}  // namespace seamline::analysis
