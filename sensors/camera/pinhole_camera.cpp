#include "sensors/camera/pinhole_camera.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "support/text/error.h"

namespace seamline::sensors {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

Vector2d distorted(const LensDistortion& lens, const Vector2d& ideal) {
  const double x = ideal.x(), y = ideal.y(), r2 = x * x + y * y;
  const double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  return {x * radial + 2 * lens.p1 * x * y + lens.p2 * (r2 + 2 * x * x),
          y * radial + lens.p1 * (r2 + 2 * y * y) + 2 * lens.p2 * x * y};
}

Matrix2d derivative(const LensDistortion& lens, const Vector2d& ideal) {
  const double x = ideal.x(), y = ideal.y(), r2 = x * x + y * y;
  const double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const double slope = lens.k1 + r2 * (2 * lens.k2 + r2 * 3 * lens.k3);  // of radial, by r^2
  Matrix2d by;
  by << radial + 2 * x * x * slope + 2 * lens.p1 * y + 6 * lens.p2 * x,
      2 * x * y * slope + 2 * lens.p1 * x + 2 * lens.p2 * y,
      2 * x * y * slope + 2 * lens.p1 * x + 2 * lens.p2 * y,
      radial + 2 * y * y * slope + 6 * lens.p1 * y + 2 * lens.p2 * x;
  return by;
}

/// Up to its first fold a lens keeps directions apart; beyond it, two directions share a place. The fold is
/// where the determinant of the derivative changes sign on the way from the axis.
bool is_one_to_one_up_to(const LensDistortion& lens, const Vector2d& ideal) {
  if (lens.is_none()) return true;
  constexpr int steps = 16;
  for (int step = 1; step <= steps; ++step)
    if (derivative(lens, ideal * (static_cast<double>(step) / steps)).determinant() <= 0) return false;
  return true;
}

}  // namespace

PinholeCamera pinhole_of_field_of_view(int width_px, int height_px, double field_of_view_deg) {
  PinholeCamera camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.fx_px = camera.fy_px = width_px / (2 * std::tan(field_of_view_deg * degree / 2));
  camera.cx_px = 0.5 * width_px;
  camera.cy_px = 0.5 * height_px;
  return camera;
}

double horizontal_field_of_view_deg(const PinholeCamera& camera) {
  const auto edge = [&](double u) { return direction_through(camera, {u, 0.5 * camera.height_px}); };
  const auto left = edge(0), right = edge(camera.width_px);
  if (!left || !right) return std::nan("");
  return std::atan2(left->cross(*right).norm(), left->dot(*right)) / degree;
}

std::optional<Vector2d> project(const PinholeCamera& camera, const Vector3d& point_m) {
  if (!(point_m.z() > 0)) return std::nullopt;
  const Vector2d ideal = point_m.head<2>() / point_m.z();
  if (!is_one_to_one_up_to(camera.distortion, ideal)) return std::nullopt;
  const Vector2d lens = distorted(camera.distortion, ideal);
  return Vector2d(camera.fx_px * lens.x() + camera.skew_px * lens.y() + camera.cx_px,
                  camera.fy_px * lens.y() + camera.cy_px);
}

std::optional<Vector3d> direction_through(const PinholeCamera& camera, const Vector2d& position_px) {
  const double y = (position_px.y() - camera.cy_px) / camera.fy_px;
  const Vector2d wanted((position_px.x() - camera.cx_px - camera.skew_px * y) / camera.fx_px, y);
  if (camera.distortion.is_none()) return Vector3d(wanted.x(), wanted.y(), 1);
  // From the axis outwards, so that Newton never has to cross the fold to the other branch.
  Vector2d ideal = Vector2d::Zero();
  constexpr int legs = 8;
  for (int leg = 1; leg <= legs; ++leg) {
    const Vector2d aim = wanted * (static_cast<double>(leg) / legs);
    for (int round = 0; round < 20; ++round) {
      const Vector2d step = derivative(camera.distortion, ideal)
                                .partialPivLu()
                                .solve(aim - distorted(camera.distortion, ideal));
      if (!step.allFinite()) return std::nullopt;
      ideal += step;
      if (step.norm() <= 1e-15 * (1 + ideal.norm())) break;
    }
  }
  const bool found = ideal.allFinite() &&
                     (distorted(camera.distortion, ideal) - wanted).norm() <= 1e-9 * (1 + wanted.norm());
  if (!found || !is_one_to_one_up_to(camera.distortion, ideal)) return std::nullopt;
  return Vector3d(ideal.x(), ideal.y(), 1);
}

bool is_in_picture(const PinholeCamera& camera, const Vector2d& position_px) {
  return position_px.x() >= 0 && position_px.x() < camera.width_px && position_px.y() >= 0 &&
         position_px.y() < camera.height_px;
}

void require_valid(const PinholeCamera& camera, const std::string& where) {
  const auto complain = [&](const char* field, const char* wanted, double found) {
    throw InputError(fmt::format("{}{}: wanted {}, found {:g}", where, field, wanted, found));
  };
  if (camera.width_px < 2) complain("width_px", "at least 2", camera.width_px);
  if (camera.height_px < 2) complain("height_px", "at least 2", camera.height_px);
  for (const auto& [field, value] : {std::pair{"fx", camera.fx_px}, std::pair{"fy", camera.fy_px}})
    if (!(value > 0) || !std::isfinite(value)) complain(field, "a focal length above 0 pixels", value);
  const LensDistortion& lens = camera.distortion;
  for (const auto& [field, value] :
       {std::pair{"cx", camera.cx_px}, std::pair{"cy", camera.cy_px}, std::pair{"skew", camera.skew_px},
        std::pair{"k1", lens.k1}, std::pair{"k2", lens.k2}, std::pair{"p1", lens.p1},
        std::pair{"p2", lens.p2}, std::pair{"k3", lens.k3}})
    if (!std::isfinite(value)) complain(field, "a finite number", value);
}

}  // namespace seamline::sensors
