// A marker is found again where it was drawn; without OpenCV's ArUco the program says so.
#include "registration/calibration/aruco.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/complaint.h"

namespace seamline::registration {
namespace {

using Eigen::Isometry3d;

constexpr double side_m = 0.16;

/// The marker with a white margin on grey; every pixel is the mean of 4 x 4 places in it.
ByteImage marker_picture(const sensors::PinholeCamera& camera, const Isometry3d& camera_from_marker) {
  const Isometry3d marker_from_camera = camera_from_marker.inverse();
  const auto brightness = [&](const Eigen::Vector2d& at_px) {
    const Eigen::Vector3d from = marker_from_camera.translation(),
                          along = marker_from_camera.linear() * *sensors::direction_through(camera, at_px);
    const Eigen::Vector3d place = from - along * (from.z() / along.z());
    const int column = static_cast<int>(std::floor((place.x() / side_m + 0.5) * marker_squares)),
              row = static_cast<int>(std::floor((0.5 - place.y() / side_m) * marker_squares));
    if (column < -1 || column > marker_squares || row < -1 || row > marker_squares) return 110.0;
    if (column < 0 || column == marker_squares || row < 0 || row == marker_squares) return 240.0;
    return marker_pattern[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] != 0 ? 240.0
                                                                                                : 20.0;
  };
  ByteImage picture{camera.width_px, camera.height_px, 1, {}};
  for (int row = 0; row < camera.height_px; ++row)
    for (int column = 0; column < camera.width_px; ++column) {
      double sum = 0;
      for (int i = 0; i < 16; ++i) sum += brightness({column + (i % 4 + 0.5) / 4, row + (i / 4 + 0.5) / 4});
      picture.values.push_back(static_cast<std::uint8_t>(std::lround(sum / 16)));
    }
  return picture;
}

/// The marker's x to its right and y up, its z towards the camera, which looks along its own z.
Isometry3d marker_pose(double distance_m, double turn_deg) {
  Isometry3d pose = Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(0.02, -0.01, distance_m));
  pose.rotate(Eigen::AngleAxisd(turn_deg * std::numbers::pi / 180, Eigen::Vector3d::UnitY()));
  pose.rotate(Eigen::AngleAxisd(0.12, Eigen::Vector3d::UnitZ()));
  pose.rotate(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
  return pose;
}

TEST(Aruco, AMarkerIsFoundWhereItWasDrawn) {
  if (!has_aruco()) GTEST_SKIP() << "built without OpenCV's ArUco";
  const sensors::PinholeCamera camera = sensors::pinhole_of_field_of_view(640, 480, 34);
  for (const double distance_m : {0.6, 1.156, 2.0})
    for (const double turn_deg : {0.0, 25.0, -45.0}) {
      const Isometry3d pose = marker_pose(distance_m, turn_deg);
      const ByteImage picture = marker_picture(camera, pose);
      const auto refined = find_marker(picture, camera, side_m, MarkerCorners::subpix),
                 plain = find_marker(picture, camera, side_m, MarkerCorners::none);
      ASSERT_TRUE(refined && plain) << distance_m << " " << turn_deg;
      EXPECT_NEAR(refined->translation().z(), distance_m, 0.006 * distance_m) << turn_deg;
      EXPECT_NEAR(plain->translation().z(), distance_m, 0.03 * distance_m) << turn_deg;
      EXPECT_LT((refined->translation() - pose.translation()).head<2>().norm(), 0.002) << distance_m;
      EXPECT_GT(refined->linear().col(0).dot(pose.linear().col(0)), 0.97) << "which side is up";
    }
  EXPECT_FALSE(find_marker(ByteImage{64, 48, 1, std::vector<std::uint8_t>(64 * 48, 128)},
                           sensors::pinhole_of_field_of_view(64, 48, 34), side_m, MarkerCorners::subpix));
}

TEST(Aruco, WithoutItTheProgramSaysSo) {
  if (has_aruco()) {
    EXPECT_NO_THROW(require_aruco());
    return;
  }
  EXPECT_EQ(test::complaint_of([] { require_aruco(); }),
            "marker: wanted a Seamline that was built with OpenCV's ArUco (Debian: libopencv-contrib-dev), "
            "found one without");
}

}  // namespace
}  // namespace seamline::registration
