#pragma once
#include "registration/frame/registered_frame.h"
#include "support/files/image.h"

namespace seamline::registration {

/// The measured pixels as coloured points, seen from beside the colour camera (paper 001, Fig. 2 a): turned
/// by 35 degrees about the upright axis through their middle, with the colour camera in orange and the depth
/// camera in blue, each a pyramid with the shape of its view. `picture` has the colour camera's size and
/// three channels.
[[nodiscard]] ByteImage points_picture(const RegisteredFrame& registered, const ByteImage& picture,
                                       const sensors::PinholeCamera& depth,
                                       const Eigen::Isometry3d& colour_from_depth);

}  // namespace seamline::registration
