#pragma once
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <concepts>
#include <utility>

namespace seamline::analysis {

/// A least-squares problem that `levenberg_marquardt` can descend, with `Parameters` parameters. A place
/// holds its `residual_sum_of_squares`.
template <class Problem>
concept LeastSquares =
    requires(const Problem& problem, const typename Problem::Place& place, typename Problem::Place& into,
             Eigen::Matrix<double, Problem::parameters, Problem::parameters>& curvature,
             Eigen::Vector<double, Problem::parameters>& gradient) {
      /// J' J and J' r, with the derivatives J of the curve by the parameters and the residuals r.
      problem.normal_equations(place, curvature, gradient);
      /// The place after a step, kept within the problem's bounds.
      problem.step(place, gradient, into);
      /// How far two places are apart.
      { problem.distance(place, place) } -> std::convertible_to<double>;
      { place.residual_sum_of_squares } -> std::convertible_to<double>;
    };

/// Descends from `best`, and leaves it at the best place found: steps of (J' J + damping diag(J' J)) move =
/// J' r (Levenberg 1944, Marquardt 1963), the damping an eighth after a step that gained and eight times as
/// large after one that did not. Stops after 60 steps, after a step shorter than 1e-7, or when damping to 1e8
/// does not help. `tried` is room for the next place, so that its memory is used again.
template <LeastSquares Problem>
void levenberg_marquardt(const Problem& problem, typename Problem::Place& best,
                         typename Problem::Place& tried) {
  constexpr int most_steps = 60;
  constexpr double smallest_move = 1e-7;
  constexpr double most_damping = 1e8, least_damping = 1e-12;
  Eigen::Matrix<double, Problem::parameters, Problem::parameters> curvature;
  Eigen::Vector<double, Problem::parameters> gradient;
  double damping = 1e-3;
  bool stale = true;  // the normal equations are not those of `best`
  for (int step = 0; step < most_steps && damping < most_damping; ++step) {
    if (stale) problem.normal_equations(best, curvature, gradient);
    auto damped = curvature;
    damped.diagonal() += damping * (curvature.diagonal().array() + 1e-9).matrix();
    const Eigen::Vector<double, Problem::parameters> move = damped.inverse() * gradient;
    problem.step(best, move, tried);
    stale = tried.residual_sum_of_squares < best.residual_sum_of_squares;
    if (!stale) {
      damping *= 8;
      continue;
    }
    const double moved = problem.distance(best, tried);
    std::swap(best, tried);
    damping = std::max(damping / 8, least_damping);
    if (moved < smallest_move) break;
  }
}

}  // namespace seamline::analysis
