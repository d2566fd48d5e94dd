#pragma once
#include <Eigen/Core>
#include <span>
#include <string>

#include "physics/rigid_world.h"

namespace seamline::renderer {

/// What of an object with these vertices can touch: a ball where all of them lie on one, within a thousandth
/// of its radius and on all sides; else a convex hull of those that reach farthest in 210 directions. Nothing
/// falls into a body's hollows. Throws InputError naming `what` where there is no volume.
[[nodiscard]] BodyShape body_shape_of(std::span<const Eigen::Vector3d> vertices_m, const std::string& what);

/// A hull of fewer points, those that reach farthest in 64 directions: asked in a third of the time, by 1 to
/// 3 % of its width too small on round sides. A ball stays.
[[nodiscard]] BodyShape coarser(const BodyShape& shape);

}  // namespace seamline::renderer
