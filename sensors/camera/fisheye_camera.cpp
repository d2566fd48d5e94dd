#include "sensors/camera/fisheye_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sensors/camera/pinhole_camera.h"

namespace seamline::sensors {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double bent(const FisheyeCamera& lens, double theta) {
  const double t2 = theta * theta;
  return theta * (1 + t2 * (lens.k1 + t2 * (lens.k2 + t2 * (lens.k3 + t2 * lens.k4))));
}

double slope_of_bent(const FisheyeCamera& lens, double theta) {
  const double t2 = theta * theta;
  return 1 + t2 * (3 * lens.k1 + t2 * (5 * lens.k2 + t2 * (7 * lens.k3 + t2 * 9 * lens.k4)));
}

/// Up to its first fold a lens keeps directions apart.
bool keeps_apart(const FisheyeCamera& lens, double theta) {
  constexpr int steps = 32;
  for (int step = 1; step <= steps; ++step)
    if (!(slope_of_bent(lens, theta * step / steps) > 0)) return false;
  return true;
}

/// The angle that is bent to `wanted`, by Newton's method from the axis outwards.
std::optional<double> angle_of(const FisheyeCamera& lens, double wanted) {
  double theta = 0;
  constexpr int legs = 8;
  for (int leg = 1; leg <= legs; ++leg) {
    const double aim = wanted * leg / legs;
    for (int round = 0; round < 20; ++round) {
      const double step = (aim - bent(lens, theta)) / slope_of_bent(lens, theta);
      if (!std::isfinite(step)) return std::nullopt;
      theta = std::clamp(theta + step, 0.0, std::numbers::pi);
      if (std::abs(step) <= 1e-15 * (1 + theta)) break;
    }
  }
  const bool found = std::abs(bent(lens, theta) - wanted) <= 1e-9 * (1 + wanted);
  return found && keeps_apart(lens, theta) ? std::optional(theta) : std::nullopt;
}

}  // namespace

std::optional<Vector2d> project(const FisheyeCamera& camera, const Vector3d& point_m) {
  const double beside = point_m.head<2>().norm();
  if (!(point_m.norm() > 0)) return std::nullopt;
  const double theta = std::atan2(beside, point_m.z());
  if (!keeps_apart(camera, theta)) return std::nullopt;
  if (beside == 0 && point_m.z() < 0) return std::nullopt;  // straight behind: every azimuth
  const Vector2d lens =
      beside > 0 ? Vector2d(point_m.head<2>() * (bent(camera, theta) / beside)) : Vector2d::Zero();
  return Vector2d(camera.fx_px * lens.x() + camera.skew_px * lens.y() + camera.cx_px,
                  camera.fy_px * lens.y() + camera.cy_px);
}

std::optional<Vector3d> direction_through(const FisheyeCamera& camera, const Vector2d& position_px) {
  const double y = (position_px.y() - camera.cy_px) / camera.fy_px;
  const Vector2d wanted((position_px.x() - camera.cx_px - camera.skew_px * y) / camera.fx_px, y);
  const double length = wanted.norm();
  const auto theta = angle_of(camera, length);
  if (!theta) return std::nullopt;
  if (length == 0) return Vector3d(0, 0, 1);
  const Vector2d aside = wanted * (std::sin(*theta) / length);
  return Vector3d(aside.x(), aside.y(), std::cos(*theta));
}

void require_valid(const FisheyeCamera& camera, const std::string& where) {
  // Its numbers are a pinhole's, but for the bend, which has four terms too.
  PinholeCamera pinhole;
  pinhole.width_px = camera.width_px;
  pinhole.height_px = camera.height_px;
  pinhole.fx_px = camera.fx_px;
  pinhole.fy_px = camera.fy_px;
  pinhole.cx_px = camera.cx_px;
  pinhole.cy_px = camera.cy_px;
  pinhole.skew_px = camera.skew_px;
  pinhole.distortion = {.k1 = camera.k1, .k2 = camera.k2, .p1 = 0, .p2 = 0, .k3 = camera.k3 + camera.k4};
  require_valid(pinhole, where);
}

}  // namespace seamline::sensors
