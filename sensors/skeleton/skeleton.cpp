#include "sensors/skeleton/skeleton.h"

#include <algorithm>
#include <numbers>

namespace seamline::sensors {
namespace {

Hinge about_x(double least_rad, double most_rad) {
  return {Eigen::Vector3d::UnitX(), least_rad, most_rad};
}
Hinge about_y(double least_rad, double most_rad) {
  return {Eigen::Vector3d::UnitY(), least_rad, most_rad};
}
Hinge about_z(double least_rad, double most_rad) {
  return {Eigen::Vector3d::UnitZ(), least_rad, most_rad};
}

/// Arm and leg of the left side (1) or the right (-1). Lengths are shares of 1.75 m.
void add_limbs(Skeleton& skeleton, const std::string& side_name, double side, double scale) {
  const auto outwards = [&](double inwards_rad, double outwards_rad) {
    return side > 0 ? about_z(-inwards_rad, outwards_rad) : about_z(-outwards_rad, inwards_rad);
  };
  const auto add = [&](const std::string& name, int parent, const Eigen::Vector3d& offset_m,
                       std::vector<Hinge> hinges) {
    skeleton.joints.push_back({side_name + name, parent, scale * offset_m, std::move(hinges)});
    return static_cast<int>(skeleton.joints.size()) - 1;
  };
  const int shoulder = add("shoulder", 0, {side * 0.19, 0.24, 0},
                           {outwards(0.6, 2.9), about_x(-3.0, 1.0), about_y(-1.6, 1.6)});
  const int elbow = add("elbow", shoulder, {0, -0.30, 0}, {about_x(-2.6, 0)});
  add("hand", elbow, {0, -0.27, 0}, {});
  const int hip =
      add("hip", 0, {side * 0.10, -0.25, 0}, {about_x(-2.1, 0.6), outwards(0.5, 0.9), about_y(-0.9, 0.9)});
  const int knee = add("knee", hip, {0, -0.43, 0}, {about_x(0, 2.5)});
  add("foot", knee, {0, -0.42, 0}, {});
}

}  // namespace

std::optional<std::size_t> Skeleton::index_of(const std::string& name) const {
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints[i].name == name) return i;
  return std::nullopt;
}

std::size_t Skeleton::hinge_count() const {
  std::size_t count = 0;
  for (const Joint& joint : joints) count += joint.hinges.size();
  return count;
}

std::vector<PlacedJoint> place_joints(const Skeleton& skeleton, const SkeletonPose& pose) {
  std::vector<PlacedJoint> placed(skeleton.joints.size());
  std::size_t angle = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Joint& joint = skeleton.joints[i];
    PlacedJoint& here = placed[i];
    if (joint.parent < 0) {
      here.position_m = pose.root_m;
    } else {
      const PlacedJoint& parent = placed[joint.parent];
      here.before = parent.orientation;
      here.position_m = parent.position_m + parent.orientation * joint.offset_m;
    }
    here.orientation = here.before;
    for (const Hinge& hinge : joint.hinges)
      here.orientation *= Eigen::AngleAxisd(pose.angles_rad[angle++], hinge.axis).toRotationMatrix();
  }
  return placed;
}

SkeletonPose rest_pose(const Skeleton& skeleton) {
  SkeletonPose pose;
  for (const Joint& joint : skeleton.joints)
    for (const Hinge& hinge : joint.hinges)
      pose.angles_rad.push_back(std::clamp(0.0, hinge.least_rad, hinge.most_rad));
  return pose;
}

Skeleton standing_person(double height_m) {
  const double scale = height_m / 1.75;
  Skeleton skeleton;
  skeleton.joints.push_back(
      {"torso",
       -1,
       Eigen::Vector3d::Zero(),
       {about_y(-std::numbers::pi, std::numbers::pi), about_x(-1.3, 1.3), about_z(-0.9, 0.9)}});
  skeleton.joints.push_back(
      {"neck", 0, scale * Eigen::Vector3d(0, 0.28, 0), {about_x(-0.9, 0.9), about_z(-0.8, 0.8)}});
  skeleton.joints.push_back({"head", 1, scale * Eigen::Vector3d(0, 0.20, 0), {}});
  add_limbs(skeleton, "left_", 1, scale);
  add_limbs(skeleton, "right_", -1, scale);
  return skeleton;
}

Skeleton with_bones_of(Skeleton skeleton, const std::vector<std::optional<Eigen::Vector3d>>& measured_m) {
  for (std::size_t i = 0; i < skeleton.joints.size(); ++i) {
    Joint& joint = skeleton.joints[i];
    if (joint.parent < 0) continue;
    const auto& start_m = measured_m[joint.parent];
    const double rest_m = joint.offset_m.norm();
    if (!start_m || !measured_m[i] || !(rest_m > 0)) continue;
    joint.offset_m *= (*measured_m[i] - *start_m).norm() / rest_m;
  }
  return skeleton;
}

}  // namespace seamline::sensors
