#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

namespace seamline::renderer {

/// Real spherical harmonics of bands 0 to `bands` - 1, orthonormal over the sphere: number l (l + 1) + m is
/// that of degree l and order m, -l to l, with cos(m phi) for m > 0 and sin(|m| phi) for m < 0, phi about z.
inline constexpr int most_bands = 8;

[[nodiscard]] constexpr int coefficient_count(int bands) {
  return bands * bands;
}

/// Values at a unit direction; `out` is as long as the bands have coefficients.
void evaluate_harmonics(int bands, const Eigen::Vector3d& direction, std::span<double> out);

/// Directions and weights whose sum is the integral over the sphere of every polynomial of degree up to
/// 2 `rows` - 1: Gauss-Legendre in z, even in azimuth.
struct SphereRule {
  std::vector<Eigen::Vector3d> directions;
  std::vector<double> weights_sr;
};
[[nodiscard]] SphereRule sphere_rule(int rows);

/// Coefficients of a function of direction (paper 001, Eqs. 6 and 7): the integral of its product with each
/// harmonic, by a rule.
template <class Function>
[[nodiscard]] Eigen::VectorXd project_harmonics(int bands, const SphereRule& rule, const Function& function) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(coefficient_count(bands));
  std::vector<double> values(static_cast<std::size_t>(coefficient_count(bands)));
  for (std::size_t i = 0; i < rule.directions.size(); ++i) {
    evaluate_harmonics(bands, rule.directions[i], values);
    const double weighted = rule.weights_sr[i] * static_cast<double>(function(rule.directions[i]));
    for (Eigen::Index k = 0; k < out.size(); ++k) out[k] += weighted * values[static_cast<std::size_t>(k)];
  }
  return out;
}

/// What turns coefficients of f into those of the turned function w -> f(R^-1 w). Bands do not mix.
[[nodiscard]] Eigen::MatrixXd harmonic_rotation(int bands, const Eigen::Matrix3d& rotation);

/// Of each degree l, what convolution with the clamped cosine max(n . w, 0) multiplies harmonics by (Funk and
/// Hecke): pi, 2 pi / 3, pi / 4, 0, ...
[[nodiscard]] std::vector<double> clamped_cosine_bands(int bands);

}  // namespace seamline::renderer
