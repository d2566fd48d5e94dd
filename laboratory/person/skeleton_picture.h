#pragma once
#include "sensors/skeleton/user_file.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// A tracked skeleton over the depth image that it was found in (paper 001, Fig. 1): depth grey (near is
/// bright, holes black), the user's pixels tinted, bones white, joints red. `frame_from_world`: into the
/// frame's camera.
[[nodiscard]] ByteImage skeleton_over_depth(const ByteImage& depth, const sensors::DepthFrame& frame,
                                            const sensors::RecordedUser& user,
                                            const Eigen::Isometry3d& frame_from_world);

}  // namespace seamline::renderer
