#pragma once
#include <Eigen/Core>
#include <vector>

namespace seamline::renderer {

/// A place where a body touches the ground, or is about to.
struct Touch {
  Eigen::Vector3d on_body_m = Eigen::Vector3d::Zero();  ///< in the body's own frame
  Eigen::Vector3d on_ground_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d push = Eigen::Vector3d::UnitY();  ///< unit, from the ground to the body
  double distance_m = 0;                            ///< along the push; negative: so deep
  bool is_corner = false;                           ///< of the body
  double impulse = 0;                               ///< what it took along the push in the last step
};

/// One touch for each cube of a grid in the body's frame and each side from which the ground pushes (of six):
/// the deepest there, a corner of the body before others of nearly its depth. So a body on many small
/// triangles has few touches, and they lie out to its corners. The order does not depend on that of
/// `touches`.
[[nodiscard]] std::vector<Touch> spread_touches(std::vector<Touch> touches, double cell_m);

/// Gives each touch the impulse of the nearest one before it, within `reach_m` and 25 degrees; each is given
/// once.
void keep_impulses(const std::vector<Touch>& before, double reach_m, std::vector<Touch>& touches);

}  // namespace seamline::renderer
