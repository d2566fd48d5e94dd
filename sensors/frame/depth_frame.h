#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "sensors/camera/pinhole_camera.h"

namespace seamline::sensors {

/// What a depth value is: the length of the ray (time of flight, paper 002 section 4), or the distance from
/// the plane of the camera (structured light, 001 Eq. 2). Always stated, never guessed.
enum class DepthConvention { radial, planar };

/// No measurement.
inline constexpr float hole = std::numeric_limits<float>::infinity();

/// What a depth camera delivers of one moment, row by row from the upper left. Metres; a hole is +infinity.
/// `amplitude` and `confidence` are empty where the sensor has none, else of the same size: the strength of
/// its own light that came back (relative units), and how far it trusts a value (0 to 1).
struct DepthFrame {
  PinholeCamera camera;
  DepthConvention convention = DepthConvention::planar;
  std::vector<float> depth_m;
  std::vector<float> amplitude;
  std::vector<float> confidence;

  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(camera.width_px) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] float at(int column, int row) const { return depth_m[index(column, row)]; }
  [[nodiscard]] static bool is_hole(float depth_m) { return depth_m == hole; }
};

/// The point of the camera frame that a pixel's value stands for (its centre's ray); 002 section 4 for radial
/// values, 001 Eq. 2, which leaves out the skew and the lens, for planar ones. Nothing for a hole.
[[nodiscard]] std::optional<Eigen::Vector3d> point_of_pixel(const DepthFrame& frame, int column, int row);

/// Every value of the frame in the other convention; holes stay holes.
[[nodiscard]] DepthFrame in_convention(const DepthFrame& frame, DepthConvention convention);

/// Turns 0, negative values, NaN and values beyond the range into holes; returns how many (infinities are
/// holes already, and not counted).
std::int64_t clean_holes(DepthFrame& frame, double nearest_m = 0, double farthest_m = 1e9);

}  // namespace seamline::sensors
