#pragma once
#include <Eigen/Core>
#include <array>

#include "analysis/joint/joint_model.h"

namespace seamline::analysis {

// What answers at one level add to the log likelihood of a curve, with exact first and second derivatives.
// Few of them are nonzero in a curve's own letters, so cells are summed in those, and the sum is brought to
// the model's coordinates once a curve.

inline constexpr double least_probability = 1e-300;  ///< under which no logarithm is taken

/// Log likelihood of cells of a curve by m, log s, l, t_2..t_K, log rho, g(1)..g(K).
struct CellSum {
  static constexpr Eigen::Index m = 0, log_scale = 1, lapse = 2, cut = 3, log_spread = 6, guess = 7,
                                size = 11;

  double value = 0;
  Eigen::Matrix<double, size, 1> gradient = Eigen::Matrix<double, size, 1>::Zero();
  /// Row <= column only.
  Eigen::Matrix<double, size, size> hessian = Eigen::Matrix<double, size, size>::Zero();
  /// Answers that can only be guesses, by rating; they are not in the value.
  std::array<double, most_joint_ratings> guesses{};
};

/// The same by the model's coordinates, guesses too: m, log s, l, t_2, log distances, log rho, h_2..h_K.
struct CurveSum {
  static constexpr Eigen::Index log_spread = 6, guess = 7, size = 10;

  double value = 0;
  Eigen::Matrix<double, size, 1> gradient = Eigen::Matrix<double, size, 1>::Zero();
  Eigen::Matrix<double, size, size> hessian = Eigen::Matrix<double, size, size>::Zero();
};

/// What the cells of a curve have in common.
struct CurveTerms {
  JointCurve curve;
  double lapse_d = 0, lapse_dd = 0;  ///< of the lapse rate by l
  /// Derivatives of `CellSum`'s coordinates by `CurveSum`'s.
  Eigen::Matrix<double, CellSum::size, CurveSum::size> by_model;
  std::array<Eigen::Index, CurveSum::size> to{};  ///< place of each coordinate in theta; -1: not in the model
};

[[nodiscard]] CurveTerms terms_of(const JointModel& model, const Eigen::VectorXd& theta, int curve);

/// Adds answers of one cell: `counts` as a row of `JointData::answers`.
void add_cell(const CurveTerms& terms, const JointCell& cell, const Eigen::Ref<const Eigen::VectorXd>& counts,
              CellSum& sum);

[[nodiscard]] CurveSum curve_sum(const CurveTerms& terms, const CellSum& cells);

/// The gradient of `curve_sum` alone.
[[nodiscard]] Eigen::Matrix<double, CurveSum::size, 1> curve_gradient(const CurveTerms& terms,
                                                                      const CellSum& cells);

}  // namespace seamline::analysis
