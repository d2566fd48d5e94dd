#pragma once
#include <vector>

#include "sensors/skeleton/skeleton.h"

namespace seamline::sensors {

/// Where joints were measured; none: not seen.
using MeasuredJoints = std::vector<std::optional<Eigen::Vector3d>>;

struct DescentOptions {
  int most_sweeps = 2000;
  double smallest_gain =
      1e-7;  ///< relative, of the sum of squares over 16 sweeps: less of it ends the descent
};

/// A skeleton fitted to measured joints.
struct FittedPose {
  SkeletonPose pose = {};
  double rms_m = 0;  ///< distance of fitted and measured joints, root mean square
  int sweeps = 0;
};

/// The place of the root and all angles by cyclic coordinate descent (paper 001, section 3; Canutescu and
/// Dunbrack 2003), from a pose. One coordinate at a time takes the value, within its limits, that makes the
/// sum of squared distances of all measured joints smallest: of an angle about the axis a through the point
/// o,
///
///     tan(change) = sum (f . (a x r)) / sum (f . r),   f = measured - o,   r = joint - o, across the axis
///
/// so the sum never grows. It ends in a minimum near its start, which need not be the least one. Throws
/// InputError when no joint was measured or the lists are of different lengths.
[[nodiscard]] FittedPose fit_pose(const Skeleton& skeleton, const MeasuredJoints& measured_m,
                                  const SkeletonPose& start, const DescentOptions& options = {});

/// Of a person, whose first hinge turns about y: first the trunk alone (the root and what hangs on it), the
/// best of descents from eight sides; then everything from there, the better one of straight and of half bent
/// limbs.
[[nodiscard]] FittedPose fit_standing_pose(const Skeleton& skeleton, const MeasuredJoints& measured_m,
                                           const DescentOptions& options = {});

}  // namespace seamline::sensors
