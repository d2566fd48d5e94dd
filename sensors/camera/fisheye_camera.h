#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

namespace seamline::sensors {

/// A fisheye of Kannala and Brandt (2006), in the form and order of OpenCV's `fisheye` module and of ROS'
/// `equidistant`: a direction theta away from the axis lands at
///
///     theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8)
///
/// from the principal point, in units of the focal length, in its own azimuth. Frame and pixels as
/// `PinholeCamera` has them; directions behind the camera (theta up to 180 degrees) have a place too.
struct FisheyeCamera {
  int width_px = 640;
  int height_px = 480;
  double fx_px = 300, fy_px = 300, cx_px = 320, cy_px = 240;
  double skew_px = 0;
  double k1 = 0, k2 = 0, k3 = 0, k4 = 0;

  auto operator<=>(const FisheyeCamera&) const = default;
};

/// Where a point of the camera frame lands in the picture, also outside it. Nothing at the camera itself, and
/// beyond the angle to which the lens keeps directions apart.
[[nodiscard]] std::optional<Eigen::Vector2d> project(const FisheyeCamera& camera,
                                                     const Eigen::Vector3d& point_m);

/// The unit direction through an image position: the inverse of `project`. Nothing where none lands there.
[[nodiscard]] std::optional<Eigen::Vector3d> direction_through(const FisheyeCamera& camera,
                                                               const Eigen::Vector2d& position_px);

/// Throws InputError, naming `where`, for sizes below 2, focal lengths that are not above 0, or values that
/// are no finite numbers.
void require_valid(const FisheyeCamera& camera, const std::string& where);

}  // namespace seamline::sensors
