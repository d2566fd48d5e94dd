#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "raytracer/tracing/mesh.h"
#include "sensors/frame/depth_frame.h"
#include "support/files/image.h"
#include "x3d/x3d_subject.h"

namespace seamline::renderer {

/// The near and far planes of a page's camera: planar metres.
struct ClipPlanes {
  double near_m = 0.1, far_m = 100;
};

/// The value of a depth buffer, 0 to 1, at a planar distance: what a perspective projection makes of it
/// (001, section 5.1). A hole (infinity) is the far plane.
///
///     w = (1 / near - 1 / z) / (1 / near - 1 / far)
[[nodiscard]] double window_depth(double planar_m, const ClipPlanes& planes);

/// Who is in front in a pixel's centre.
enum class InFront : std::uint8_t { nothing_virtual = 0, real = 1, object = 2 };

/// A subject as the page's pixels have it. Frame of the camera of X3D: x right, y up, z back, metres.
struct X3dFrame {
  sensors::DepthFrame depth;      ///< planar, of the photograph's pixels; a hole is sky
  std::vector<InFront> in_front;  ///< by rays through the pixels' centres, row by row
  ClipPlanes planes;              ///< around everything that is seen
  DepthMesh ghosts;               ///< a mesh of the depth, in the frame of X3D
  DepthMesh blockers;  ///< the same without sheets over jumps, which would keep the sun's light away
};
[[nodiscard]] X3dFrame frame_of(const X3dSubject& subject, int threads);

/// Depths as a picture whose codes a shader reads: 24 bits in red, green and blue (most significant first),
/// steps of range_m / (2^24 - 1); 0 is a hole, and what lies beyond the range is the range.
[[nodiscard]] ByteImage depth_codes(std::span<const float> depth_m, int width_px, int height_px,
                                    double range_m);

/// The depth that such a pixel stands for; infinity for a hole.
[[nodiscard]] double depth_of_code(std::span<const std::uint8_t, 3> code, double range_m);

/// The largest depth that is no hole; 1 where there is none.
[[nodiscard]] double depth_range_m(std::span<const float> depth_m);

}  // namespace seamline::renderer
