// Calibration finds what was planted, says how well it knows it, and refuses what determines nothing.
#include "registration/calibration/calibrate.h"

#include <gtest/gtest.h>

#include "registration/calibration/opencv.h"
#include "tests/complaint.h"
#include "tests/registration/planted_rig.h"

namespace seamline::registration {
namespace {

using namespace test;
using seamline::test::complaint_of;

class Calibration : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_opencv()) GTEST_SKIP() << "built without OpenCV";
  }
  const PlantedRig rig_ = planted_rig();
  const Board board_{.columns = 8, .rows = 6, .square_m = 0.03};
  Random random_{5};
};

TEST(Reprojection, DerivativesAreThoseOfSmallChanges) {
  const PlantedRig rig = planted_rig();
  Estimate estimate;
  estimate.cameras = {rig.depth, rig.colour};
  for (sensors::PinholeCamera& camera : estimate.cameras) camera.skew_px = 2;
  estimate.second_from_first = rig.colour_from_depth;
  estimate.first_from_view = {sensors::pose_of({0.1, -0.2, 0.9}, {1, 2, 0.5}, 25)};
  for (int camera = 0; camera < 2; ++camera) {
    const SeenPoint seen{camera, 0, {0.12, 0.07, 0.03}, {0, 0}};
    const auto here = reproject(estimate, seen);
    ASSERT_TRUE(here);
    // The same place as everybody else's.
    const Eigen::Vector3d first_m = estimate.first_from_view[0] * seen.point_m;
    const auto place = sensors::project(estimate.cameras[static_cast<std::size_t>(camera)],
                                        camera == 0 ? first_m : estimate.second_from_first * first_m);
    EXPECT_LT((*place - here->position_px).norm(), 1e-10);
    const auto expect_derivative = [&](const Eigen::Vector2d& by, const Estimate& more, const Estimate& less,
                                       double step) {
      const Eigen::Vector2d slope =
          (reproject(more, seen)->position_px - reproject(less, seen)->position_px) / (2 * step);
      EXPECT_LT((slope - by).norm(), 1e-6 * (1 + by.norm()));
    };
    constexpr double step = 1e-6;
    for (int i = 0; i < camera_parameters; ++i) {
      Eigen::Matrix<double, camera_parameters, 1> by = Eigen::Matrix<double, camera_parameters, 1>::Zero();
      by[i] = step;
      Estimate more = estimate, less = estimate;
      auto& changing = more.cameras[static_cast<std::size_t>(camera)];
      changing = changed(changing, by);
      auto& other = less.cameras[static_cast<std::size_t>(camera)];
      other = changed(other, -by);
      expect_derivative(here->by_camera.col(i), more, less, step);
    }
    for (int i = 0; i < pose_parameters; ++i) {
      Eigen::Matrix<double, pose_parameters, 1> by = Eigen::Matrix<double, pose_parameters, 1>::Zero();
      by[i] = step;
      Estimate more = estimate, less = estimate;
      more.first_from_view[0] = changed(more.first_from_view[0], by);
      less.first_from_view[0] = changed(less.first_from_view[0], -by);
      expect_derivative(here->by_view.col(i), more, less, step);
      more = less = estimate;
      more.second_from_first = changed(more.second_from_first, by);
      less.second_from_first = changed(less.second_from_first, -by);
      expect_derivative(here->by_second.col(i), more, less, step);
    }
  }
}

TEST_F(Calibration, WithoutNoiseItFindsTheRigItself) {
  const auto poses = planted_boards(board_, 8, random_);
  const BoardPictures depth =
      seen_boards(rig_.depth, Eigen::Isometry3d::Identity(), board_, poses, 0, random_);
  const BoardPictures colour = seen_boards(rig_.colour, rig_.colour_from_depth, board_, poses, 0, random_);
  const Refined found = calibrate_two_cameras(board_, depth, colour, "test");
  EXPECT_LT(found.rms_px, 1e-9);
  EXPECT_LT(difference(found.estimate.cameras[0], rig_.depth).norm(), 1e-6);
  EXPECT_LT(difference(found.estimate.cameras[1], rig_.colour).norm(), 1e-6);
  EXPECT_LT(difference(found.estimate.second_from_first, rig_.colour_from_depth).norm(), 1e-9);
  EXPECT_EQ(found.first_of_view(0), 24);
  EXPECT_EQ(found.covariance.rows(), 24 + 8 * 6);
}

TEST_F(Calibration, ABoardCountedFromItsOtherEndIsTheSameBoard) {
  const auto poses = planted_boards(board_, 6, random_);
  const BoardPictures depth =
      seen_boards(rig_.depth, Eigen::Isometry3d::Identity(), board_, poses, 0.1, random_);
  BoardPictures colour = seen_boards(rig_.colour, rig_.colour_from_depth, board_, poses, 0.1, random_);
  const Refined plain = calibrate_two_cameras(board_, depth, colour, "test");
  for (const std::size_t one : {0U, 3U}) std::reverse(colour.boards[one].begin(), colour.boards[one].end());
  const Refined turned = calibrate_two_cameras(board_, depth, colour, "test");
  EXPECT_LT((plain.estimate.second_from_first.matrix() - turned.estimate.second_from_first.matrix()).norm(),
            1e-7);
  EXPECT_NEAR(plain.rms_px, turned.rms_px, 1e-8);
}

TEST_F(Calibration, NoiseOfACoordinateIsTheOnePlanted) {
  const auto poses = planted_boards(board_, 12, random_);
  const Refined found = calibrate_camera(
      board_, seen_boards(rig_.colour, Eigen::Isometry3d::Identity(), board_, poses, 0.2, random_), "test");
  // s^2 / sigma^2 is chi-squared of 1071 degrees: sigma within 2.2 % a standard deviation.
  EXPECT_NEAR(found.sigma_px, 0.2, 4 * 0.022 * 0.2);
  EXPECT_LT(found.rms_px, std::sqrt(2.0) * found.sigma_px);
}

TEST_F(Calibration, HoldsAPlantedRigWithinItsOwnCovarianceInTwentyTrials) {
  const RigCoverage coverage = rig_coverage(20, 1);  // 95 %: 13 to 20 of 20; calibration_full_test has 200
  for (const Held& held : {coverage.together, coverage.depth, coverage.colour, coverage.pose})
    EXPECT_TRUE(held.is_95_percent()) << held.held << " of " << held.trials;
  const Held pairs = pairs_coverage(200, 2);
  EXPECT_TRUE(pairs.is_95_percent()) << pairs.held << " of " << pairs.trials;
}

TEST_F(Calibration, TheCovarianceIsThatOfRepeatedTrials) {
  // The spread of the found poses over many trials of one scene, against what each trial says of itself.
  const std::vector<PointPair> scene = planted_pairs(rig_, 15, 0, random_);
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(6), said = Eigen::VectorXd::Zero(6);
  constexpr int trials = 600;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<PointPair> pairs = scene;
    for (PointPair& pair : pairs)
      pair.position_px += 0.3 * Eigen::Vector2d(random_.normal(), random_.normal());
    const Refined found = pose_of_pairs(rig_.colour, pairs, "test");
    variance += difference(found.estimate.first_from_view[0], rig_.colour_from_depth).cwiseAbs2() / trials;
    said += found.covariance.diagonal() / trials;
  }
  // A variance of 600 is known within 5.8 % a standard deviation.
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(variance[i] / said[i], 1, 4.5 * 0.058) << i;
}

TEST_F(Calibration, WhatDeterminesNothingIsRefused) {
  auto poses = planted_boards(board_, 2, random_);
  const auto pictures = [&] {
    return seen_boards(rig_.colour, Eigen::Isometry3d::Identity(), board_, poses, 0.1, random_);
  };
  EXPECT_EQ(complaint_of([&] { (void)calibrate_camera(board_, pictures(), "pictures"); }),
            "pictures: wanted at least 3 pictures that show the whole board, found 2");
  poses = planted_boards(board_, 4, random_);
  BoardPictures one = pictures(), other = pictures();
  other.boards.pop_back();
  EXPECT_EQ(complaint_of([&] { (void)calibrate_two_cameras(board_, one, other, "pairs"); }),
            "pairs: wanted as many boards of one camera as of the other, found 4 and 3");
  other.boards.back().pop_back();
  EXPECT_EQ(complaint_of([&] { (void)calibrate_camera(board_, other, "pictures"); }),
            "pictures: wanted 48 corners of each board, found 47");
  // The same picture four times, without noise: facing the camera, size and distance are one.
  poses.assign(4, sensors::pose_of({-0.1, -0.07, 0.6}, {0, 0, 1}, 0));
  BoardPictures flat = seen_boards(sensors::pinhole_of_field_of_view(640, 480, 60),
                                   Eigen::Isometry3d::Identity(), board_, poses, 0, random_);
  EXPECT_NE(complaint_of([&] { (void)calibrate_camera(board_, flat, "pictures"); }), "no complaint");
}

TEST_F(Calibration, PairsThatDetermineNoPoseAreRefused) {
  std::vector<PointPair> pairs = planted_pairs(rig_, 5, 0, random_);
  const auto complaint = [&] {
    return complaint_of([&] { (void)pose_of_pairs(rig_.colour, pairs, "p.csv"); });
  };
  EXPECT_EQ(complaint(), "p.csv: wanted at least 6 pairs, found 5");
  pairs = planted_pairs(rig_, 9, 0, random_);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    pairs[i].point_m =
        Eigen::Vector3d(0.1, 0.2, 2) + static_cast<double>(i) * Eigen::Vector3d(0.1, 0.02, 0.1);
  EXPECT_EQ(complaint(), "p.csv: wanted points that do not lie on one line, found 9 on one");
  for (PointPair& pair : pairs) pair = pairs.front();
  EXPECT_EQ(complaint(), "p.csv: wanted points that do not lie on one line, found 9 on one");
  // Points in a plane are enough.
  pairs = planted_pairs(rig_, 9, 0, random_);
  for (PointPair& pair : pairs) {
    pair.point_m.z() = 2;
    pair.position_px = *sensors::project(rig_.colour, rig_.colour_from_depth * pair.point_m);
  }
  const Refined found = pose_of_pairs(rig_.colour, pairs, "p.csv");
  EXPECT_LT(difference(found.estimate.first_from_view[0], rig_.colour_from_depth).norm(), 1e-6);
}

}  // namespace
}  // namespace seamline::registration
