// Joint angles from joint positions: planted poses are found again, the error never grows, limits hold.
#include <gtest/gtest.h>

#include <cmath>

#include "sensors/skeleton/cyclic_descent.h"
#include "support/arithmetic/random.h"
#include "support/text/error.h"

namespace seamline::sensors {
namespace {

/// Every angle somewhere within a share of its limits.
SkeletonPose drawn_pose(const Skeleton& skeleton, double share, Random& random) {
  SkeletonPose pose = rest_pose(skeleton);
  pose.root_m = {random.uniform(), 1 + random.uniform(), -3 * random.uniform()};
  std::size_t angle = 0;
  for (const Joint& joint : skeleton.joints)
    for (const Hinge& hinge : joint.hinges) {
      const double drawn_rad = hinge.least_rad + random.uniform() * (hinge.most_rad - hinge.least_rad);
      pose.angles_rad[angle] = share * drawn_rad + (1 - share) * pose.angles_rad[angle];
      ++angle;
    }
  return pose;
}

MeasuredJoints joints_of(const Skeleton& skeleton, const SkeletonPose& pose) {
  MeasuredJoints measured_m;
  for (const PlacedJoint& joint : place_joints(skeleton, pose)) measured_m.emplace_back(joint.position_m);
  return measured_m;
}

void expect_limits(const Skeleton& skeleton, const SkeletonPose& pose) {
  std::size_t angle = 0;
  for (const Joint& joint : skeleton.joints)
    for (const Hinge& hinge : joint.hinges) {
      EXPECT_GE(pose.angles_rad[angle], hinge.least_rad) << joint.name;
      EXPECT_LE(pose.angles_rad[angle], hinge.most_rad) << joint.name;
      ++angle;
    }
}

TEST(CyclicDescent, FindsPlantedPosesAgain) {
  const Skeleton skeleton = standing_person();
  Random random(7);
  int near = 0;
  constexpr int poses = 30;
  for (int i = 0; i < poses; ++i) {
    const MeasuredJoints measured_m = joints_of(skeleton, drawn_pose(skeleton, 0.6, random));
    const FittedPose fitted = fit_standing_pose(skeleton, measured_m);
    expect_limits(skeleton, fitted.pose);
    near += fitted.rms_m < 0.002 ? 1 : 0;
    EXPECT_LT(fitted.rms_m, 0.06);
  }
  EXPECT_GE(near, poses * 9 / 10);
}

TEST(CyclicDescent, TheErrorNeverGrows) {
  const Skeleton skeleton = standing_person();
  Random random(11);
  const MeasuredJoints measured_m = joints_of(skeleton, drawn_pose(skeleton, 0.9, random));
  SkeletonPose pose = rest_pose(skeleton);
  double last_m = std::numeric_limits<double>::infinity();
  for (int sweep = 0; sweep < 200; ++sweep) {
    const FittedPose fitted = fit_pose(skeleton, measured_m, pose, {.most_sweeps = 1});
    EXPECT_LE(fitted.rms_m, last_m * (1 + 1e-12));
    last_m = fitted.rms_m;
    pose = fitted.pose;
  }
}

TEST(CyclicDescent, ALimitIsKeptWhereThePositionsAreBeyondIt) {
  // A knee that is bent forwards by 1 rad: the best that a knee may do is to be straight.
  const Skeleton skeleton = standing_person();
  Skeleton without_limits = skeleton;
  const std::size_t knee = *skeleton.index_of("left_knee"), hip = *skeleton.index_of("left_hip");
  without_limits.joints[knee].hinges[0].least_rad = -2;
  SkeletonPose bent = rest_pose(skeleton);
  std::size_t angle = 0;
  for (std::size_t i = 0; i < knee; ++i) angle += skeleton.joints[i].hinges.size();
  bent.angles_rad[angle] = -1;
  MeasuredJoints measured_m = joints_of(without_limits, bent);
  const FittedPose free = fit_pose(without_limits, measured_m, rest_pose(without_limits));
  EXPECT_LT(free.rms_m, 1e-6);
  EXPECT_NEAR(free.pose.angles_rad[angle], -1, 1e-5);
  const FittedPose limited = fit_pose(skeleton, measured_m, rest_pose(skeleton));
  expect_limits(skeleton, limited.pose);
  EXPECT_DOUBLE_EQ(limited.pose.angles_rad[angle], 0);
  EXPECT_GT(limited.rms_m, 0.01);
  EXPECT_EQ(skeleton.joints[knee].parent, static_cast<int>(hip));
}

TEST(CyclicDescent, NoiseOfJointsBecomesNoMoreThanItself) {
  const Skeleton skeleton = standing_person();
  Random random(3);
  const SkeletonPose planted = drawn_pose(skeleton, 0.5, random);
  MeasuredJoints measured_m = joints_of(skeleton, planted);
  constexpr double sigma_m = 0.02;
  for (auto& place_m : measured_m)
    for (int c = 0; c < 3; ++c) (*place_m)[c] += sigma_m * std::sqrt(12.0) * (random.uniform() - 0.5);
  const FittedPose fitted = fit_standing_pose(skeleton, measured_m);
  // 45 measured numbers, 25 angles and 3 places: what is left is at most the noise, 0.02 sqrt(3).
  EXPECT_LT(fitted.rms_m, sigma_m * std::sqrt(3.0));
  EXPECT_GT(fitted.rms_m, 0.1 * sigma_m);
}

TEST(CyclicDescent, JointsThatWereNotSeenAreLeftOut) {
  const Skeleton skeleton = standing_person();
  Random random(5);
  MeasuredJoints measured_m = joints_of(skeleton, drawn_pose(skeleton, 0.5, random));
  measured_m[*skeleton.index_of("left_hand")].reset();
  measured_m[*skeleton.index_of("head")].reset();
  EXPECT_LT(fit_standing_pose(skeleton, measured_m).rms_m, 0.002);
  EXPECT_THROW((void)fit_standing_pose(skeleton, MeasuredJoints(skeleton.joints.size())), InputError);
  EXPECT_THROW((void)fit_standing_pose(skeleton, MeasuredJoints(3)), InputError);
}

TEST(Skeleton, BonesKeepTheirLengthsInEveryPoseAndTakeThoseMeasured) {
  const Skeleton skeleton = standing_person(1.6);
  Random random(2);
  const auto placed = place_joints(skeleton, drawn_pose(skeleton, 1, random));
  MeasuredJoints measured_m;
  for (const PlacedJoint& joint : placed) measured_m.emplace_back(joint.position_m);
  const Skeleton other = with_bones_of(standing_person(1.9), measured_m);
  for (std::size_t i = 1; i < placed.size(); ++i) {
    const auto parent = static_cast<std::size_t>(skeleton.joints[i].parent);
    EXPECT_NEAR((placed[i].position_m - placed[parent].position_m).norm(), skeleton.joints[i].offset_m.norm(),
                1e-12);
    EXPECT_NEAR(other.joints[i].offset_m.norm(), skeleton.joints[i].offset_m.norm(), 1e-12);
    EXPECT_NEAR(placed[i].orientation.determinant(), 1, 1e-12);
  }
}

}  // namespace
}  // namespace seamline::sensors
