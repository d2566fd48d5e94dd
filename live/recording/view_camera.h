#pragma once
#include "sensors/camera/pinhole_camera.h"
#include "support/files/image.h"

namespace seamline::live {

/// The colour camera as everything after reading sees it: no lens, no skew (paper 002, section 6, exports
/// undistorted pictures too), its picture of a size of the same shape, or of its own (0 x 0). Throws
/// InputError naming `field` for a size of another shape.
[[nodiscard]] sensors::PinholeCamera view_camera(const sensors::PinholeCamera& colour, int width_px,
                                                 int height_px, const std::string& field);

/// A picture of the colour camera as the view camera would have taken it: linear between pixels, black where
/// the colour camera shows nothing. The same codes where the two cameras are one. 3 channels. The same bytes
/// for any number of threads.
[[nodiscard]] ByteImage view_picture(const ByteImage& picture, const sensors::PinholeCamera& colour,
                                     const sensors::PinholeCamera& view, int threads);

}  // namespace seamline::live
