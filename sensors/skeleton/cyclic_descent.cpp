#include "sensors/skeleton/cyclic_descent.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/text/error.h"

namespace seamline::sensors {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int sweeps_of_gain = 16;
constexpr int sides = 8;

double sum_of_squares(const std::vector<PlacedJoint>& placed, const MeasuredJoints& measured_m) {
  double sum = 0;
  for (std::size_t i = 0; i < placed.size(); ++i)
    if (measured_m[i]) sum += (placed[i].position_m - *measured_m[i]).squaredNorm();
  return sum;
}

/// Which joints move when a joint turns: `moves[i]` of all behind it.
std::vector<std::vector<bool>> list_descendants(const Skeleton& skeleton) {
  const std::size_t count = skeleton.joints.size();
  std::vector<std::vector<bool>> moves(count, std::vector<bool>(count, false));
  for (std::size_t i = 0; i < count; ++i)
    for (int up = skeleton.joints[i].parent; up >= 0; up = skeleton.joints[up].parent) moves[up][i] = true;
  return moves;
}

/// The angle within the limits that is best where the sum of squares is a constant - cos(angle - best_rad)
/// times something.
double within(const Hinge& hinge, double best_rad) {
  const double turns = std::ceil((hinge.least_rad - best_rad) / (2 * pi));
  const double first = best_rad + 2 * pi * turns;
  if (first <= hinge.most_rad) return first;
  return std::cos(hinge.least_rad - best_rad) >= std::cos(hinge.most_rad - best_rad) ? hinge.least_rad
                                                                                     : hinge.most_rad;
}

/// One sweep over all coordinates.
class Sweep {
 public:
  Sweep(const Skeleton& skeleton, const MeasuredJoints& measured_m)
      : skeleton_(skeleton), measured_m_(measured_m), moves_(list_descendants(skeleton)) {}

  void operator()(SkeletonPose& pose) const {
    move_root(pose);
    std::size_t angle = 0;
    for (std::size_t i = 0; i < skeleton_.joints.size(); ++i)
      for (std::size_t h = 0; h < skeleton_.joints[i].hinges.size(); ++h) turn(i, h, angle++, pose);
  }

 private:
  void move_root(SkeletonPose& pose) const {
    const std::vector<PlacedJoint> placed = place_joints(skeleton_, pose);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
    for (std::size_t i = 0; i < placed.size(); ++i) {
      if (!measured_m_[i]) continue;
      sum += *measured_m_[i] - placed[i].position_m;
      ++count;
    }
    pose.root_m += sum / count;
  }

  void turn(std::size_t joint, std::size_t hinge, std::size_t angle, SkeletonPose& pose) const {
    const std::vector<PlacedJoint> placed = place_joints(skeleton_, pose);
    const std::vector<Hinge>& hinges = skeleton_.joints[joint].hinges;
    Eigen::Matrix3d frame = placed[joint].before;
    for (std::size_t h = 0; h < hinge; ++h)
      frame *= Eigen::AngleAxisd(pose.angles_rad[angle - hinge + h], hinges[h].axis).toRotationMatrix();
    const Eigen::Vector3d axis = frame * hinges[hinge].axis, origin_m = placed[joint].position_m;
    double along = 0, across = 0;
    for (std::size_t i = 0; i < placed.size(); ++i) {
      if (!moves_[joint][i] || !measured_m_[i]) continue;
      Eigen::Vector3d r = placed[i].position_m - origin_m;
      r -= axis * axis.dot(r);
      const Eigen::Vector3d f = *measured_m_[i] - origin_m;
      along += f.dot(r);
      across += f.dot(axis.cross(r));
    }
    if (!(std::hypot(along, across) > 1e-12)) return;  // no angle is better than another
    pose.angles_rad[angle] = within(hinges[hinge], pose.angles_rad[angle] + std::atan2(across, along));
  }

  const Skeleton& skeleton_;
  const MeasuredJoints& measured_m_;
  std::vector<std::vector<bool>> moves_;
};

std::size_t count_measured(const Skeleton& skeleton, const MeasuredJoints& measured_m) {
  if (measured_m.size() != skeleton.joints.size())
    throw input_error({.field = "joints",
                       .wanted = fmt::format("{} of them, as the skeleton has", skeleton.joints.size()),
                       .found = fmt::format("{}", measured_m.size())});
  const auto count = static_cast<std::size_t>(
      std::count_if(measured_m.begin(), measured_m.end(), [](const auto& one) { return one.has_value(); }));
  if (count == 0)
    throw input_error({.field = "joints", .wanted = "at least one that was measured", .found = "none"});
  return count;
}

}  // namespace

FittedPose fit_pose(const Skeleton& skeleton, const MeasuredJoints& measured_m, const SkeletonPose& start,
                    const DescentOptions& options) {
  const double count = count_measured(skeleton, measured_m);
  const Sweep sweep(skeleton, measured_m);
  FittedPose fitted{.pose = start};
  double sum = sum_of_squares(place_joints(skeleton, fitted.pose), measured_m), before = sum;
  for (; fitted.sweeps < options.most_sweeps; ++fitted.sweeps) {
    sweep(fitted.pose);
    sum = sum_of_squares(place_joints(skeleton, fitted.pose), measured_m);
    if (sum < 1e-20 * count) break;
    if (fitted.sweeps % sweeps_of_gain != sweeps_of_gain - 1) continue;
    if (before - sum <= options.smallest_gain * before) break;
    before = sum;
  }
  fitted.rms_m = std::sqrt(sum / count);
  return fitted;
}

namespace {

/// The root and what hangs on it directly, where anything of it was measured: the angles of limbs do not move
/// these, and limbs cannot draw the trunk aside. The best of descents from several sides.
FittedPose fit_trunk(const Skeleton& skeleton, const MeasuredJoints& measured_m,
                     const DescentOptions& options) {
  MeasuredJoints trunk_m = measured_m;
  for (std::size_t i = 0; i < trunk_m.size(); ++i)
    if (skeleton.joints[i].parent > 0) trunk_m[i].reset();
  const bool none =
      std::none_of(trunk_m.begin(), trunk_m.end(), [](const auto& one) { return one.has_value(); });
  std::optional<FittedPose> best;
  for (int side = 0; side < sides; ++side) {
    SkeletonPose start = rest_pose(skeleton);
    if (!start.angles_rad.empty()) start.angles_rad.front() = 2 * pi * side / sides - pi;
    const FittedPose fitted = fit_pose(skeleton, none ? measured_m : trunk_m, start, options);
    if (!best || fitted.rms_m < best->rms_m) best = fitted;
  }
  return *best;
}

/// Every angle in the middle of its limits.
SkeletonPose half_bent_pose(const Skeleton& skeleton) {
  SkeletonPose pose;
  for (const Joint& joint : skeleton.joints)
    for (const Hinge& hinge : joint.hinges)
      pose.angles_rad.push_back(0.5 * (hinge.least_rad + hinge.most_rad));
  return pose;
}

}  // namespace

FittedPose fit_standing_pose(const Skeleton& skeleton, const MeasuredJoints& measured_m,
                             const DescentOptions& options) {
  (void)count_measured(skeleton, measured_m);
  const FittedPose trunk = fit_trunk(skeleton, measured_m, options);
  FittedPose best;
  for (const SkeletonPose& bent : {rest_pose(skeleton), half_bent_pose(skeleton)}) {
    SkeletonPose start = bent;
    start.root_m = trunk.pose.root_m;
    std::copy_n(trunk.pose.angles_rad.begin(), skeleton.joints.front().hinges.size(),
                start.angles_rad.begin());
    const FittedPose fitted = fit_pose(skeleton, measured_m, start, options);
    if (best.pose.angles_rad.empty() || fitted.rms_m < best.rms_m) best = fitted;
  }
  return best;
}

}  // namespace seamline::sensors
