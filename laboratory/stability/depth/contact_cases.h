#pragma once
#include <functional>

#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/stability_case.h"
#include "raytracer/tracing/geometry.h"

namespace seamline::stability {

/// Where a ray starts that leaves a surface; the product's is `ray_start`.
using StartRule = std::function<Eigen::Vector3f(const SurfacePoint& point, const Eigen::Vector3f& direction)>;

/// A box whose bottom is `gap_m` above a floor (negative: it penetrates), seen from 2, 20 and 200 m. Counts
/// paths from the floor under the box that find light.
[[nodiscard]] Finding try_contact(float gap_m);

/// Rays that leave a ball outwards, seen from 1e-3 to 1e6 m: how many hit the ball itself.
[[nodiscard]] Finding try_leaving_rays(const StartRule& start = ray_start);

/// A ball of albedo 1 under a sky of radiance 1: every path must bring 1.
[[nodiscard]] Finding try_white_ball();

}  // namespace seamline::stability
