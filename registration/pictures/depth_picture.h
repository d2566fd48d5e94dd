#pragma once
#include "sensors/frame/depth_frame.h"
#include "support/files/image.h"

namespace seamline::registration {

/// Distances for people: near is bright, holes are black, even steps of 1 / distance between the 1st and the
/// 99th percentile, so that outliers do not decide.
[[nodiscard]] ByteImage depth_picture(const sensors::DepthFrame& frame);

}  // namespace seamline::registration
