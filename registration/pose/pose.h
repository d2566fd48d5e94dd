#pragma once
#include <Eigen/Geometry>
#include <cstdint>

namespace seamline::registration {

/// Paper 001, section 4.2: the depth camera's pose from the colour camera's, which is tracked, and the
/// transformation (dR, dt) between the two. With x_C = R_C x_W + t_C, which is what 001's Eqs. 3 and 4 use,
/// and x_D = dR x_C + dt,
///
///     R_D = dR R_C        t_D = dR t_C + dt
///
/// The paper's Eq. 1 is printed as R_D = R_C dR, t_D = R_C t_C + dt, which contradicts its Eqs. 3 and 4: a
/// point of the world would reach the depth camera by turning with dR before it is in the colour camera's
/// frame, and t_C would be turned by R_C once more.
[[nodiscard]] Eigen::Isometry3d depth_from_world(const Eigen::Isometry3d& depth_from_colour,
                                                 const Eigen::Isometry3d& colour_from_world);

/// The same in the other direction, from what a file of poses most often holds: where the colour camera
/// stands in the world.
[[nodiscard]] Eigen::Isometry3d world_from_depth(const Eigen::Isometry3d& world_from_colour,
                                                 const Eigen::Isometry3d& colour_from_depth);

/// How wrong a calibration is. Axis and direction are drawn from the seed, evenly over all directions and
/// independently of each other, so that the same seed with another size is the same error, larger or smaller.
struct CalibrationError {
  double rotation_deg = 0;
  double displacement_m = 0;
  std::uint64_t seed = 1;
};

/// The pose that a camera wrongly has: it is turned by `rotation_deg` about an axis through its own place,
/// and its place is `displacement_m` beside the true one. Without an error it is the pose itself, bit for
/// bit. Throws InputError for an error that is not a finite number, a rotation outside 0 to 180 degrees or a
/// displacement outside 0 to 1e9 m.
[[nodiscard]] Eigen::Isometry3d with_calibration_error(const Eigen::Isometry3d& colour_from_depth,
                                                       const CalibrationError& error);

}  // namespace seamline::registration
