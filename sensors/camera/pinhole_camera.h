#pragma once
#include <Eigen/Core>
#include <compare>
#include <optional>
#include <string>

namespace seamline::sensors {

/// Brown's lens distortion (Brown 1971, in the form and order of OpenCV): of ideal image coordinates x = X/Z,
/// y = Y/Z with r^2 = x^2 + y^2,
///
///     x' = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2)
///     y' = y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y
struct LensDistortion {
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;

  [[nodiscard]] bool is_none() const { return k1 == 0 && k2 == 0 && p1 == 0 && p2 == 0 && k3 == 0; }
  auto operator<=>(const LensDistortion&) const = default;
};

/// A pinhole camera with a lens, in the camera frame: x right, y down, z forward, metres. Image coordinates
/// are pixels from the upper left corner of the picture, so that the centre of pixel (0, 0) is (0.5, 0.5);
/// OpenCV counts from that centre, half a pixel less.
///
///     u = fx x' + skew y' + cx        v = fy y' + cy
struct PinholeCamera {
  int width_px = 640;
  int height_px = 480;
  double fx_px = 525;
  double fy_px = 525;
  double cx_px = 320;
  double cy_px = 240;
  double skew_px = 0;
  LensDistortion distortion;

  auto operator<=>(const PinholeCamera&) const = default;
};

/// A camera with square pixels, its principal point in the middle, and this horizontal field of view.
[[nodiscard]] PinholeCamera pinhole_of_field_of_view(int width_px, int height_px,
                                                     double horizontal_field_of_view_deg);

/// Angle between the rays through the middles of the left and right edge of the picture.
[[nodiscard]] double horizontal_field_of_view_deg(const PinholeCamera& camera);

/// Where a point of the camera frame lands in the picture, also outside it. Nothing when it is not before the
/// camera (z <= 0), or beyond the radius to which the lens model is one to one.
[[nodiscard]] std::optional<Eigen::Vector2d> project(const PinholeCamera& camera,
                                                     const Eigen::Vector3d& point_m);

/// The direction through an image position, with z = 1: the inverse of `project`, by Newton's method on the
/// lens. Nothing where no direction lands there.
[[nodiscard]] std::optional<Eigen::Vector3d> direction_through(const PinholeCamera& camera,
                                                               const Eigen::Vector2d& position_px);

/// Whether an image position lies in the picture.
[[nodiscard]] bool is_in_picture(const PinholeCamera& camera, const Eigen::Vector2d& position_px);

/// Throws InputError, naming `where`, for sizes below 2, focal lengths that are not above 0, or values that
/// are no finite numbers.
void require_valid(const PinholeCamera& camera, const std::string& where);

}  // namespace seamline::sensors
