#pragma once
#include <algorithm>
#include <limits>
#include <numbers>

#include "renderer/tracing/geometry.h"

namespace seamline::renderer {

inline constexpr float inverse_pi = std::numbers::inv_pi_v<float>;
inline constexpr float endless = std::numeric_limits<float>::infinity();

/// The ray that leaves a surface point, off the surface (see `ray_start`).
[[nodiscard]] inline Ray leaving_ray(const SurfacePoint& point, const Eigen::Vector3f& direction,
                                     float far_m) {
  return {ray_start(point, direction), direction, far_m};
}

/// Cosine with the sun's direction, 0 when the sun is below the surface's horizon.
[[nodiscard]] inline float sun_cosine(const SurfacePoint& point, const Eigen::Vector3f& to_sun) {
  return above_horizon(point, to_sun) ? std::max(0.0F, point.normal.dot(to_sun)) : 0.0F;
}

}  // namespace seamline::renderer
