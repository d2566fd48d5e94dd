#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

/// The GGX distribution of small mirrors with Smith's height-correlated masking (Walter et al., EGSR 2007;
/// Heitz, JCGT 3(2), 2014). mu_o and mu_i are cosines with the normal, above 0, of the directions to the
/// viewer and to the light. In `float` for pictures, in `double` for tables.
namespace seamline::renderer {

/// sqrt(mu^2 + alpha^2 (1 - mu^2)): with it Smith's functions have no tangent, which would be infinite at the
/// horizon. 1 + Lambda(mu) = (mu + root) / (2 mu).
template <class Real>
[[nodiscard]] Real smith_root(Real mu, Real alpha) {
  return std::sqrt(mu * mu + alpha * alpha * (1 - mu * mu));
}

/// G2 / (4 mu_o mu_i): D times this is what a surface whose mirrors lose nothing does, without its cosine.
template <class Real>
[[nodiscard]] Real visibility(Real mu_o, Real mu_i, Real alpha) {
  return Real(0.5) / (mu_i * smith_root(mu_o, alpha) + mu_o * smith_root(mu_i, alpha));
}

/// G2 / G1(mu_o): what is left of the light of a direction that was sampled by visible normals.
template <class Real>
[[nodiscard]] Real share_unmasked(Real mu_o, Real mu_i, Real alpha) {
  const Real root_o = smith_root(mu_o, alpha);
  return mu_i * (mu_o + root_o) / (mu_i * root_o + mu_o * smith_root(mu_i, alpha));
}

/// D: mirrors per steradian whose normal has this squared sine with the surface's normal.
template <class Real>
[[nodiscard]] Real mirror_density(Real squared_sine, Real alpha) {
  const Real squared_alpha = alpha * alpha;
  const Real spread = squared_sine + squared_alpha * (1 - squared_sine);
  return squared_alpha / (std::numbers::pi_v<Real> * spread * spread);
}

/// Per steradian of the direction to the light that `visible_mirror` leads to: G1 D / (4 mu_o).
template <class Real>
[[nodiscard]] Real visible_density(Real density_of_mirrors, Real mu_o, Real alpha) {
  return density_of_mirrors * Real(0.5) / (mu_o + smith_root(mu_o, alpha));
}

/// Normal of a mirror as often as the viewer sees it, in a frame whose third axis is the surface's normal
/// (Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", HPG 2023). `turn` and `height` are
/// of [0, 1). Zero for the one point that names no normal.
template <class Real>
[[nodiscard]] Eigen::Matrix<Real, 3, 1> visible_mirror(const Eigen::Matrix<Real, 3, 1>& to_viewer, Real alpha,
                                                       Real turn, Real height) {
  using Vector = Eigen::Matrix<Real, 3, 1>;
  const Vector stretched = Vector(alpha * to_viewer.x(), alpha * to_viewer.y(), to_viewer.z()).normalized();
  const Real angle = 2 * std::numbers::pi_v<Real> * turn;
  const Real z = (1 - height) * (1 + stretched.z()) - stretched.z();
  const Real sine = std::sqrt(std::max(Real(0), 1 - z * z));
  const Vector half(sine * std::cos(angle) + stretched.x(), sine * std::sin(angle) + stretched.y(),
                    std::max(Real(0), z + stretched.z()));
  const Vector mirror(alpha * half.x(), alpha * half.y(), half.z());
  const Real length = mirror.norm();
  return length > 0 ? Vector(mirror / length) : Vector(Vector::Zero());
}

/// Schlick's (1 - c)^5.
template <class Real>
[[nodiscard]] Real schlick_weight(Real cosine) {
  const Real left = std::clamp(1 - cosine, Real(0), Real(1));
  return left * left * left * left * left;
}

}  // namespace seamline::renderer
