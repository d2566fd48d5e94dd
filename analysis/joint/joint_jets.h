#pragma once
#include <Eigen/Core>
#include <array>

#include "analysis/joint/joint_model.h"

namespace seamline::analysis {

// One curve of the joint model with first and second derivatives by its own coordinates; what likelihood and
// scores are made of.

inline constexpr Eigen::Index at_m = 0, at_scale = 1, at_lapse = 2, at_cut = 3, at_spread = 6, at_guess = 7;
inline constexpr Eigen::Index curve_size = 10;
using CurveVector = Eigen::Matrix<double, curve_size, 1>;
using CurveMatrix = Eigen::Matrix<double, curve_size, curve_size>;

inline constexpr double least_probability = 1e-300;  ///< under which no logarithm is taken

/// A value with its first and second derivatives.
struct Jet {
  double value = 0;
  CurveVector d = CurveVector::Zero();
  CurveMatrix dd = CurveMatrix::Zero();
};

/// What the cells of a curve have in common.
struct CurveTerms {
  JointCurve curve;
  double lapse_d = 0, lapse_dd = 0;           ///< of the lapse rate by l
  std::array<double, 3> distance{};           ///< t_k - t_{k-1}; the first is 1, the derivative of t_2
  std::array<Jet, most_joint_ratings> guess;  ///< g(r)
  std::array<Eigen::Index, curve_size> to{};  ///< place of each coordinate in theta; -1: not in the model
};

[[nodiscard]] CurveTerms terms_of(const JointModel& model, const Eigen::VectorXd& theta, int curve);

/// A level of a curve: psi, what it lacks to 1 without cancellation, and q(r).
struct LevelJets {
  Jet seen;
  double unseen = 0;
  std::array<Jet, most_joint_ratings> q;
};

/// `x` is finite.
[[nodiscard]] LevelJets level_jets(const CurveTerms& terms, double x);

}  // namespace seamline::analysis
