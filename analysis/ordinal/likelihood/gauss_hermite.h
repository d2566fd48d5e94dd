#pragma once
#include <Eigen/Core>

namespace seamline::analysis {

/// Nodes z_q and weights w_q with sum_q w_q f(z_q) = integral of exp(-z^2) f(z) dz, exact for polynomials up
/// to degree 2n - 1. Nodes rise and are symmetric about 0.
struct GaussHermite {
  Eigen::VectorXd node;
  Eigen::VectorXd weight;
};

/// By the eigenvalues of the Jacobi matrix (Golub and Welsch 1969). 1 <= nodes <= 100.
[[nodiscard]] GaussHermite gauss_hermite(int nodes);

}  // namespace seamline::analysis
