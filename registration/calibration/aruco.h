#pragma once
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string_view>

#include "sensors/camera/pinhole_camera.h"
#include "support/files/image.h"

namespace seamline::registration {

// A marker whose pose a photograph shows, as the markers of paper 002 do. OpenCV's ArUco (its contrib
// package) is behind `find_marker`; built without it, `require_aruco` says so and `find_marker` may not be
// called.

/// The marker with the number 0 of OpenCV's dictionary of 50 markers of 4 x 4 squares, within a black border
/// as wide as a square: 6 x 6 squares, row by row from the upper left, 1: white.
inline constexpr int marker_squares = 6;
inline constexpr std::array<std::array<int, marker_squares>, marker_squares> marker_pattern = {{
    {0, 0, 0, 0, 0, 0},
    {0, 1, 0, 1, 1, 0},
    {0, 0, 1, 0, 1, 0},
    {0, 0, 0, 1, 1, 0},
    {0, 0, 0, 1, 0, 0},
    {0, 0, 0, 0, 0, 0},
}};

/// How corners are refined: not at all, or to the saddle of the grey values around them (OpenCV's SUBPIX).
enum class MarkerCorners { none, subpix };
[[nodiscard]] std::string_view word(MarkerCorners corners);

/// Throws InputError, naming the Debian package, when Seamline was built without ArUco.
void require_aruco();
[[nodiscard]] bool has_aruco();

/// Where the marker with sides of `side_m` is in the camera's frame, from a grey picture (one channel) by a
/// camera without a lens; the marker's origin is its middle, x to its right, y up, z out of it. Nothing where
/// it is not found.
[[nodiscard]] std::optional<Eigen::Isometry3d> find_marker(const ByteImage& grey,
                                                           const sensors::PinholeCamera& camera,
                                                           double side_m, MarkerCorners corners);

}  // namespace seamline::registration
