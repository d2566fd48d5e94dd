#pragma once
#include <Eigen/Core>

#include "analysis/ordinal/likelihood/link.h"
#include "analysis/ordinal/likelihood/ordinal_data.h"

namespace seamline::analysis {

/// The ends of a row's interval on the latent axis, without the participant's effect: cut_k - x beta above,
/// cut_{k-1} - x beta below; infinite beyond the last cuts. Parameters are (cuts, beta, ...).
struct RowEnds {
  double upper = 0, lower = 0;
};

[[nodiscard]] RowEnds row_ends(const OrdinalProblem& problem, const Eigen::VectorXd& parameters,
                               const Eigen::VectorXd& x_beta, Eigen::Index row);

/// Rows that are summed together: begin <= row < end.
struct RowRange {
  Eigen::Index begin = 0, end = 0;
  [[nodiscard]] Eigen::Index size() const { return end - begin; }
};

/// First derivatives of the rows' log P with respect to their two ends, one entry a row of the range.
struct RowSlopes {
  Eigen::ArrayXd u, l;
};

/// Second derivatives, one entry a row of the range.
struct RowCurvatures {
  Eigen::ArrayXd uu, ul, ll;
};

/// Adds the rows' part of d log L / d(cuts, beta) to the first entries of `gradient`.
void add_gradient(const OrdinalProblem& problem, const RowRange& rows, const RowSlopes& slopes,
                  Eigen::VectorXd& gradient);

/// Adds the rows' part of the second derivatives with respect to (cuts, beta) to the first rows and columns
/// of `hessian`.
void add_hessian(const OrdinalProblem& problem, const RowRange& rows, const RowCurvatures& curvatures,
                 Eigen::MatrixXd& hessian);

}  // namespace seamline::analysis
