#pragma once
#include <Eigen/Core>
#include <optional>

#include "live/frame/pixel_rays.h"
#include "renderer/realtime/depth_picture.h"

namespace seamline::live {

/// What a pixel shows of the real world: planar depth, and the normal, unit, towards the eye.
struct FittedSurface {
  float planar_m = 0;
  Eigen::Vector3f normal;
};

/// The plane through the depths of 5 x 5 pixels, up to `reach_px` (at least 2) beside this one, by least
/// squares of 1 / depth, which is linear over the picture of a plane. Depths that differ from the pixel's own
/// by more than a tenth are of another surface. None: too few are left, or they lie in one line.
[[nodiscard]] std::optional<FittedSurface> fitted_surface(const renderer::DepthPicture& depth,
                                                          const PixelRays& rays, int x, int y, int reach_px);

}  // namespace seamline::live
