#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace seamline::sensors {

/// An axis about which a joint turns, and how far.
struct Hinge {
  Eigen::Vector3d axis =
      Eigen::Vector3d::UnitX();  ///< unit, in the frame that the hinges before it have left
  double least_rad = -std::numbers::pi, most_rad = std::numbers::pi;
};

/// A joint and the bone that leads to it.
struct Joint {
  std::string name;
  int parent = -1;                                     ///< a joint before it; -1: the root
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();  ///< from its parent, in its parent's frame
  std::vector<Hinge> hinges;  ///< turned in this order, each within what those before it have turned
};

/// Joints, each behind its parent; the first is the root.
struct Skeleton {
  std::vector<Joint> joints;

  /// Of a joint's name; none: there is no such joint.
  [[nodiscard]] std::optional<std::size_t> index_of(const std::string& name) const;
  [[nodiscard]] std::size_t hinge_count() const;
};

/// Where a skeleton stands and how it is bent.
struct SkeletonPose {
  Eigen::Vector3d root_m = Eigen::Vector3d::Zero();
  std::vector<double> angles_rad;  ///< of every hinge, in the order of the joints
};

/// What a pose makes of every joint, in the world.
struct PlacedJoint {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d before = Eigen::Matrix3d::Identity();       ///< world from its parent's frame
  Eigen::Matrix3d orientation = Eigen::Matrix3d::Identity();  ///< world from its own frame
};
[[nodiscard]] std::vector<PlacedJoint> place_joints(const Skeleton& skeleton, const SkeletonPose& pose);

/// All angles 0, or as near to it as their limits let them.
[[nodiscard]] SkeletonPose rest_pose(const Skeleton& skeleton);

/// The fifteen joints that OpenNI tracks (paper 001, section 3), of a person so tall who stands with hanging
/// arms, y up, looking along +z, the left side along +x. Limits are wide ones of grown people. A head and
/// hands and feet turn nothing that could be seen, and have no hinges.
[[nodiscard]] Skeleton standing_person(double height_m = 1.75);

/// The same with every bone as long as between the measured joints, where both ends are measured.
[[nodiscard]] Skeleton with_bones_of(Skeleton skeleton,
                                     const std::vector<std::optional<Eigen::Vector3d>>& measured_m);

}  // namespace seamline::sensors
