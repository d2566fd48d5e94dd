#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sensors/frame/depth_frame.h"

namespace seamline::registration {

/// Depth as the colour camera would have measured it: planar, in its pixels, holes where nothing is known.
/// The masks are of the same size, 1 for yes.
struct RegisteredFrame {
  sensors::DepthFrame frame;
  std::vector<std::uint8_t> filled;    ///< a depth was brought here; 0 exactly where the frame has a hole
  std::vector<std::uint8_t> extruded;  ///< filled, but only by depth extended beyond the depth camera's view
  std::vector<std::uint8_t> invented;  ///< filled from depth that a repair had put where nothing was measured
};

/// A frame of this camera without any depth.
[[nodiscard]] RegisteredFrame empty_frame(const sensors::PinholeCamera& colour);

/// How many pixels of a mask are 1.
[[nodiscard]] std::int64_t count_of(std::span<const std::uint8_t> mask);

/// Every pixel's point in the frame of the colour camera, row by row; holes, and pixels whose place no ray of
/// the lens reaches, are NaN. The same bytes for any number of threads (0: one for each core).
[[nodiscard]] std::vector<Eigen::Vector3d> points_in_colour_frame(const sensors::DepthFrame& measured,
                                                                  const Eigen::Isometry3d& colour_from_depth,
                                                                  int threads = 0);

/// What every registration asks of its input. Throws InputError naming field, wanted and found, for a camera
/// or pose that is none, and values or a mask (empty: nothing invented) of another size than the frame.
void require_valid(const sensors::DepthFrame& measured, const Eigen::Isometry3d& colour_from_depth,
                   const sensors::PinholeCamera& colour, std::span<const std::uint8_t> invented);

}  // namespace seamline::registration
