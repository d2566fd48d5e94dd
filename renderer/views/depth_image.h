#pragma once
#include <functional>
#include <optional>

#include "raytracer/scene/camera.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// Distance from the camera's plane (eye space, planar) of what `nearest_m` finds along the ray through the
/// centre of each pixel, as a length of the ray; infinity where that finds nothing. 1 channel.
[[nodiscard]] Image planar_depth_m(const Camera& camera,
                                   const std::function<std::optional<float>(const Ray&)>& nearest_m);

/// Depth as a 2D-plus-depth picture has it (paper 000, section 2.2.2): planar metres over the stated maximum,
/// from 0 to 1, as 8-bit codes of 255 steps; what is farther, and what is nowhere, is 1. Within the maximum a
/// depth is kept to half a step, max / 510.
[[nodiscard]] ByteImage depth_codes(const Image& planar_m, double max_depth_m);

/// The depth that codes stand for, planar metres, 1 channel; what has the code 255 is at the maximum.
[[nodiscard]] Image depth_of_codes(const ByteImage& codes, double max_depth_m);

/// Two pictures of one size side by side; grey becomes colour.
[[nodiscard]] ByteImage beside(const ByteImage& left, const ByteImage& right);

/// The left or right half of a picture.
[[nodiscard]] ByteImage half_of(const ByteImage& picture, bool right);

}  // namespace seamline::renderer
