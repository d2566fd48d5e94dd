#pragma once
#include <string>

#include "registration/frame/registered_frame.h"
#include "support/files/image.h"

namespace seamline::registration {

/// The measured pixels of a registered frame as coloured points, a binary PLY file (little-endian; float x,
/// y, z in metres, unsigned bytes red, green, blue in sRGB). Every pixel of the colour camera with a depth
/// that is not extruded is one point, on the ray of its centre, with the colour of that pixel alone.
/// `frame_from_colour` brings the points into the frame of the file, which `frame_name` names in a comment.
/// `picture` has the colour camera's size and three channels or more. Throws InputError for one of another
/// size.
[[nodiscard]] std::string point_cloud_ply(const RegisteredFrame& registered, const ByteImage& picture,
                                          const Eigen::Isometry3d& frame_from_colour,
                                          const std::string& frame_name);

}  // namespace seamline::registration
