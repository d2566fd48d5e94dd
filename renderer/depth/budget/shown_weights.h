#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "raytracer/light/light.h"
#include "raytracer/scene/camera.h"
#include "raytracer/tracing/geometry.h"

namespace seamline::renderer {

/// What real surfaces do with a virtual object. Wrong depth of a surface shows where it does one of these.
enum class DepthRole {
  receiver,  ///< it lies in the object's shadow, or near the object under the sky
  blocker,   ///< its shadow falls on the object, or it hides the sky from it
  occluder   ///< it is seen in front of the object, or right beside it
};
inline constexpr std::size_t depth_roles = 3;

/// From which width of a uniform depth map on people stop seeing what a role does, in px: the largest that
/// the paper's Table 1 states for receivers (perceptual threshold), shadow overlaps and occlusions ("slightly
/// noticeable").
inline constexpr std::array<double, depth_roles> role_threshold_px = {426, 1596, 1126};

/// The share of what there is to see that people see at a width: 1 / (1 + exp((log2 W - log2 T) / 0.5)).
[[nodiscard]] double share_seen(DepthRole role, double width_px);

/// How much wrong depth in a direction would show, by role: 0 (not) to 1. A panorama about the camera, as
/// depth maps are.
struct ShownWeights {
  int width_px = 0, height_px = 0;
  std::vector<std::array<float, depth_roles>> texels;
};

/// What the weights are found by.
struct ShownScene {
  const Geometry& truth;   ///< real surfaces, about the camera
  const Geometry& object;  ///< what is virtual
  const Light& light;
  const Camera& photograph;  ///< of one eye; a lens's or a panorama's sees everything
  int threads = 1;
};

/// One direction in about a third of a degree, and one degree around all that is found. Rays ask:
/// receivers, on what the photograph shows: whether the object is between a surface and a sun or lamp;
/// blockers, anywhere: whether the object is on the line from a sun or lamp through the surface and beyond;
/// occluders: whether the object is in this direction. Towards the sky, both of the first get
/// (r / d)^2 of an object of radius r at distance d, and nothing beyond the distance at which the sky ends.
[[nodiscard]] ShownWeights where_it_shows(const ShownScene& scene);

/// Whether there is nothing to spend by.
[[nodiscard]] bool nothing_shows(const ShownWeights& weights);

}  // namespace seamline::renderer
