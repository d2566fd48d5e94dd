#pragma once
#include <cstdint>
#include <string>

#include "sensors/frame/depth_frame.h"

namespace seamline::sensors {

/// A depth buffer of graphics hardware: planar distances between two planes, in whole steps that are fine
/// near the eye and coarse far away.
struct DepthBuffer {
  double nearest_m = 0.1;
  double farthest_m = 100;
  int bits = 24;
};

/// Throws InputError naming `where` unless 0 < nearest < farthest and bits are 8 to 32.
void require_valid(const DepthBuffer& buffer, const std::string& where);

/// The step of a planar distance, 0 at the nearest plane, 2^bits - 1 at the farthest; what is nearer or
/// farther counts as on the plane:
///
///     round((2^bits - 1) (1 / near - 1 / z) / (1 / near - 1 / far))
[[nodiscard]] std::int64_t depth_buffer_step(const DepthBuffer& buffer, double planar_m);

/// What one step is worth at a distance, in metres: z^2 (1 / near - 1 / far) / (2^bits - 1).
[[nodiscard]] double depth_buffer_step_m(const DepthBuffer& buffer, double planar_m);

/// The test of paper 002 (section 5), a pixel: whether the real thing that the frame shows at an image
/// position hides a virtual one at this planar distance. Both are compared in metres along the camera's axis
/// (eye coordinates); the value is that of the pixel, the nearest neighbour. A hole hides nothing.
[[nodiscard]] bool hides_in_metres(const DepthFrame& planar, double x_px, double y_px,
                                   double virtual_planar_m);

/// The same after both were turned into steps of a depth buffer, which paper 002 rejects: of equal steps the
/// virtual thing is kept.
[[nodiscard]] bool hides_in_buffer(const DepthFrame& planar, double x_px, double y_px,
                                   double virtual_planar_m, const DepthBuffer& buffer);

}  // namespace seamline::sensors
