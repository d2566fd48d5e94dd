// Poses are composed as the equations that use them need it, and wrong by exactly as much as was asked for.
#include "registration/pose/pose.h"

#include <gtest/gtest.h>

#include <numbers>

#include "sensors/rig/rig.h"
#include "tests/complaint.h"

namespace seamline::registration {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using seamline::test::complaint_of;
using sensors::pose_of;

double angle_deg(const Isometry3d& a, const Isometry3d& b) {
  return AngleAxisd(Matrix3d(a.linear() * b.linear().transpose())).angle() * 180 / std::numbers::pi;
}

TEST(Pose, Paper001sEquation1MustBeTurnedRoundToAgreeWithItsEquations3And4) {
  const Isometry3d colour_from_world = pose_of({0.3, -0.2, 1.5}, {1, 2, 3}, 40);
  const Isometry3d depth_from_colour = pose_of({0.025, 0.001, -0.002}, {0, 1, 0.2}, 7);
  const Matrix3d r_c = colour_from_world.linear(), dr = depth_from_colour.linear();
  const Vector3d t_c = colour_from_world.translation(), dt = depth_from_colour.translation();
  const Vector3d point_world(0.4, -0.7, 3.1);
  const Vector3d point_colour = r_c * point_world + t_c;  // inside Eq. 4
  const Vector3d point_depth = dr * point_colour + dt;    // what (dR, dt) is
  // Eq. 3 must give the point of the world back.
  const auto by_eq_3 = [&](const Matrix3d& r_d, const Vector3d& t_d) -> Vector3d {
    return r_d.inverse() * (point_depth - t_d);
  };
  EXPECT_LT((by_eq_3(dr * r_c, dr * t_c + dt) - point_world).norm(), 1e-12);
  EXPECT_GT((by_eq_3(r_c * dr, r_c * t_c + dt) - point_world).norm(), 0.1);  // as printed

  const Isometry3d composed = depth_from_world(depth_from_colour, colour_from_world);
  EXPECT_LT((composed.linear() - dr * r_c).norm() + (composed.translation() - dr * t_c - dt).norm(), 1e-14);
  const Isometry3d back = world_from_depth(colour_from_world.inverse(), depth_from_colour.inverse());
  EXPECT_LT((back * point_depth - point_world).norm(), 1e-12);
}

TEST(CalibrationError, IsAsLargeAsAskedForAndNoneIsThePoseItself) {
  const Isometry3d pose = pose_of({0.06, 0.01, -0.02}, {1, 0, 1}, 12);
  for (const std::uint64_t seed : {1U, 2U, 77U})
    for (const double degrees : {0.01, 0.5, 3.0, 90.0}) {
      const Isometry3d wrong = with_calibration_error(
          pose, {.rotation_deg = degrees, .displacement_m = degrees / 100, .seed = seed});
      EXPECT_NEAR(angle_deg(wrong, pose), degrees, 1e-9 * degrees + 1e-9);
      EXPECT_NEAR((wrong.translation() - pose.translation()).norm(), degrees / 100, 1e-12);
      EXPECT_NO_THROW(sensors::require_rigid(wrong, "pose"));
    }
  const Isometry3d same = with_calibration_error(pose, {.seed = 5});
  EXPECT_EQ(same.matrix(), pose.matrix());
}

TEST(CalibrationError, OneSeedIsOneDirectionAndTurningDoesNotDisplace) {
  const Isometry3d pose = Isometry3d::Identity();
  const auto wrong = [&](double degrees, double metres, std::uint64_t seed) {
    return with_calibration_error(pose, {.rotation_deg = degrees, .displacement_m = metres, .seed = seed});
  };
  const AngleAxisd small(Matrix3d(wrong(1, 0, 3).linear())), large(Matrix3d(wrong(20, 0, 3).linear()));
  EXPECT_LT((small.axis() - large.axis()).norm(), 1e-9);
  EXPECT_EQ(wrong(20, 0, 3).translation(), pose.translation());
  EXPECT_EQ(wrong(0, 0.1, 3).linear(), pose.linear());
  EXPECT_LT((wrong(0, 0.1, 3).translation() * 3 - wrong(5, 0.3, 3).translation()).norm(), 1e-12);
  EXPECT_GT((wrong(0, 0.1, 3).translation() - wrong(0, 0.1, 4).translation()).norm(), 1e-3);
}

TEST(CalibrationError, DirectionsAreEvenOverTheSphere) {
  Vector3d mean = Vector3d::Zero();
  Matrix3d square = Matrix3d::Zero();
  constexpr int draws = 20000;
  for (int seed = 0; seed < draws; ++seed) {
    const Vector3d at =
        with_calibration_error(Isometry3d::Identity(),
                               {.displacement_m = 1, .seed = static_cast<std::uint64_t>(seed)})
            .translation();
    mean += at / draws;
    square += at * at.transpose() / draws;
  }
  // Standard deviations: 1 / sqrt(3 draws) of a mean, at most sqrt(4 / 45 / draws) of a square.
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 4.5 / std::sqrt(3.0 * draws));
  EXPECT_LT((square - Matrix3d::Identity() / 3).cwiseAbs().maxCoeff(), 4.5 * std::sqrt(4.0 / 45 / draws));
}

TEST(CalibrationError, ImpossibleOnesAreRefused) {
  const Isometry3d pose = Isometry3d::Identity();
  EXPECT_EQ(complaint_of([&] { (void)with_calibration_error(pose, {.rotation_deg = 181}); }),
            "calibration error: rotation_deg: wanted a number from 0 to 180 degrees, found 181");
  EXPECT_EQ(complaint_of([&] { (void)with_calibration_error(pose, {.displacement_m = -1}); }),
            "calibration error: displacement_m: wanted a number from 0 to 1000000000 m, found -1");
}

}  // namespace
}  // namespace seamline::registration
