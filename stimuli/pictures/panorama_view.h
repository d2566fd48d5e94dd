#pragma once
#include <array>

#include "stimuli/definition/views/look_definition.h"
#include "support/files/image.h"

namespace seamline::inline stimuli {

/// What people see of a panorama's codes at a pose (yaw, pitch in degrees): each pixel the bilinear mean of
/// four codes, as window and page draw it, rounded.
[[nodiscard]] ByteImage panorama_view(const ByteImage& panorama, const LookDefinition& look,
                                      const std::array<double, 2>& pose_deg);

/// Yaw and pitch in degrees of the middle of an object (from 1) in a panorama's click map: its mean
/// direction. Straight ahead where it is not there.
[[nodiscard]] std::array<double, 2> object_pose_deg(const ByteImage& object_ids, int object_index);

}  // namespace seamline::inline stimuli
