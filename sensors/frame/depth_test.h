#pragma once
#include <cmath>
#include <compare>
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

  auto operator<=>(const DepthBuffer&) const = default;
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

/// Whether a real thing hides a virtual one, both planar distances: the nearer one in metres, or, with a
/// buffer, that of the smaller step. A hole hides nothing.
[[nodiscard]] bool hides(double real_planar_m, double virtual_planar_m, const DepthBuffer* buffer);

/// A value between the centres of four neighbours, (column, row) being that of the upper left one and what
/// is left over how far the place lies from it: linear in both. `at` gives a pixel's value, also beyond the
/// border. A hole where the nearest of the four is one; the other holes have no weight.
template <class At>
[[nodiscard]] float linear_between(double column, double row, const At& at) {
  const double left = std::floor(column), top = std::floor(row);
  const double right_share = column - left, lower_share = row - top;
  const int x = static_cast<int>(left), y = static_cast<int>(top);
  if (DepthFrame::is_hole(at(x + (right_share < 0.5 ? 0 : 1), y + (lower_share < 0.5 ? 0 : 1)))) return hole;
  double sum = 0, weights = 0;
  for (const int down : {0, 1})
    for (const int across : {0, 1}) {
      const float value = at(x + across, y + down);
      if (DepthFrame::is_hole(value)) continue;
      const double weight =
          (across == 1 ? right_share : 1 - right_share) * (down == 1 ? lower_share : 1 - lower_share);
      sum += weight * static_cast<double>(value);
      weights += weight;
    }
  return static_cast<float>(sum / weights);
}

/// The value at an image position, between the pixels' centres as above; half a pixel along the border it is
/// that of the outermost pixels.
[[nodiscard]] float depth_between(const DepthFrame& frame, double x_px, double y_px);

}  // namespace seamline::sensors
