#pragma once
#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace seamline::renderer {

/// An orthonormal frame about a unit vector, its third column (Duff et al., "Building an Orthonormal Basis,
/// Revisited", JCGT 6(1), 2017).
[[nodiscard]] inline Eigen::Matrix3f local_axes(const Eigen::Vector3f& n) {
  const float sign = std::copysign(1.0F, n.z());
  const float a = -1.0F / (sign + n.z());
  const float b = n.x() * n.y() * a;
  Eigen::Matrix3f axes;
  axes.col(0) = Eigen::Vector3f(1.0F + sign * n.x() * n.x() * a, sign * b, -sign * n.x());
  axes.col(1) = Eigen::Vector3f(b, sign + n.y() * n.y() * a, -n.y());
  axes.col(2) = n;
  return axes;
}

/// A direction about a unit normal whose density is its cosine over pi. `point` is of [0, 1)^2.
[[nodiscard]] inline Eigen::Vector3f cosine_weighted(const Eigen::Vector3f& normal,
                                                     const Eigen::Array2f& point) {
  const float sine = std::sqrt(point[0]);
  const float angle = 2.0F * std::numbers::pi_v<float> * point[1];
  return local_axes(normal) *
         Eigen::Vector3f(sine * std::cos(angle), sine * std::sin(angle), std::sqrt(1.0F - point[0]));
}

}  // namespace seamline::renderer
