#include "registration/files/lens_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace seamline::registration {
namespace {

using Eigen::Vector2d;

/// Whether places move outwards all the way to a direction: beyond a fold they come back into the picture.
bool is_before_the_fold(const LensModel& model, const Vector2d& ideal) {
  constexpr int parts = 12;
  double before = 0;
  for (int part = 1; part <= parts; ++part) {
    const double length = model(ideal * (static_cast<double>(part) / parts)).norm();
    if (!(length > before)) return ideal.isZero();
    before = length;
  }
  return true;
}

/// Directions on a grid whose places lie in the picture.
std::vector<Vector2d> seen_directions(const LensModel& model, const sensors::PinholeCamera& camera) {
  const Vector2d focal(camera.fx_px, camera.fy_px), centre(camera.cx_px, camera.cy_px),
      size(camera.width_px, camera.height_px);
  const double reach = 1.6 * std::max((centre.cwiseQuotient(focal)).maxCoeff(),
                                      ((size - centre).cwiseQuotient(focal)).maxCoeff());
  constexpr int steps = 80;
  std::vector<Vector2d> seen;
  for (int row = -steps; row <= steps; ++row)
    for (int column = -steps; column <= steps; ++column) {
      const Vector2d ideal(reach * column / steps, reach * row / steps);
      const Vector2d place = model(ideal).cwiseProduct(focal) + centre;
      if (!place.allFinite() || !is_before_the_fold(model, ideal)) continue;
      if ((place.array() >= 0).all() && (place.array() <= size.array()).all()) seen.push_back(ideal);
    }
  return seen;
}

/// What the five terms multiply, in the order k1, k2, p1, p2, k3.
Eigen::Matrix<double, 2, 5> terms_at(const Vector2d& ideal) {
  const double x = ideal.x(), y = ideal.y(), r2 = x * x + y * y;
  Eigen::Matrix<double, 2, 5> terms;
  terms << x * r2, x * r2 * r2, 2 * x * y, r2 + 2 * x * x, x * r2 * r2 * r2,  //
      y * r2, y * r2 * r2, r2 + 2 * y * y, 2 * x * y, y * r2 * r2 * r2;
  return terms;
}

}  // namespace

LensFit fit_brown(const LensModel& model, const sensors::PinholeCamera& camera) {
  const std::vector<Vector2d> seen = seen_directions(model, camera);
  Eigen::MatrixXd terms(2 * static_cast<Eigen::Index>(seen.size()), 5);
  Eigen::VectorXd shifts(terms.rows());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto row = 2 * static_cast<Eigen::Index>(i);
    terms.middleRows<2>(row) = terms_at(seen[i]);
    shifts.segment<2>(row) = model(seen[i]) - seen[i];
  }
  LensFit fit{.lens = {}, .worst_px = std::numeric_limits<double>::infinity()};
  if (seen.size() < 5) return fit;
  // Lawson's way towards the smallest largest error: what is off weighs more in the next round.
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(terms.rows());
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::VectorXd k =
        (weights.asDiagonal() * terms).colPivHouseholderQr().solve(weights.cwiseProduct(shifts));
    const Eigen::VectorXd left = terms * k - shifts;
    double worst_px = 0;
    for (Eigen::Index i = 0; i < left.size(); i += 2)
      worst_px = std::max(worst_px, Vector2d(left[i] * camera.fx_px, left[i + 1] * camera.fy_px).norm());
    if (worst_px < fit.worst_px)
      fit = {.lens = {.k1 = k[0], .k2 = k[1], .p1 = k[2], .p2 = k[3], .k3 = k[4]}, .worst_px = worst_px};
    const double largest = left.cwiseAbs().maxCoeff();
    if (!(largest > 0)) break;
    weights = weights.cwiseProduct((left.cwiseAbs().array() / largest + 1e-3).sqrt().matrix());
  }
  return fit;
}

}  // namespace seamline::registration
