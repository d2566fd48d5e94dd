#pragma once
#include "raytracer/tracing/geometry.h"
#include "renderer/depth/depth_map.h"

namespace seamline::renderer {

/// A W x W/2 depth map of what surrounds the origin: one ray through each texel centre, never filtered
/// (paper 4.1). With a yaw, texel column c looks where column c + yaw_texels of the unturned panorama does.
[[nodiscard]] DepthMap capture_depth(const Geometry& geometry, int width_px, double yaw_texels, int threads);

}  // namespace seamline::renderer
