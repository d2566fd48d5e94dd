// Five frames of a Kinect: what their files hold, and the floor in them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>

#include "sensors/files/depth_file.h"
#include "sensors/repair/planes.h"
#include "tests/complaint.h"
#include "tests/real_data.h"

namespace seamline::sensors {
namespace {

using Eigen::Vector3d;
using test::complaint_of;
using ::testing::HasSubstr;

DepthFileForm kinect() {
  DepthFileForm form;
  form.camera = {.width_px = 640,
                 .height_px = 480,
                 .fx_px = 518,
                 .fy_px = 519,
                 .cx_px = 326,
                 .cy_px = 254,
                 .skew_px = 0,
                 .distortion = {}};
  form.metres_per_step = 0.001;
  return form;
}

std::filesystem::path depth_of(int frame) {
  return test::real_data() / "rgbd" / ("slambook_depth_" + std::to_string(frame) + ".pgm");
}

TEST(RealFrames, TheKinectFramesReadAsTheirNotesSay) {
  SKIP_WITHOUT_REAL_DATA();
  DepthFileForm form = kinect();
  const double shares[] = {0.32, -1, -1, -1, 0.28};
  for (int frame = 1; frame <= 5; ++frame) {
    const DepthFile file = read_depth_file(depth_of(frame), form);
    const double share = static_cast<double>(file.holes) / (640 * 480);
    if (shares[frame - 1] > 0) {
      EXPECT_NEAR(share, shares[frame - 1], 0.01) << frame;
    }
    for (const float depth_m : file.frame.depth_m)
      if (!DepthFrame::is_hole(depth_m)) {
        ASSERT_GT(depth_m, 0.3F);
        ASSERT_LT(depth_m, 15.0F);
      }
  }
  form.metres_per_step = 1;
  EXPECT_THAT(complaint_of([&] { (void)read_depth_file(depth_of(1), form); }),
              HasSubstr("give 0.001 metres a step"));
}

TEST(RealFrames, TheFloorOfTheKinectFramesIsOnePlaneInTheirWorld) {
  SKIP_WITHOUT_REAL_DATA();
  std::ifstream poses(test::real_data() / "rgbd" / "slambook_pose.txt");
  Vector3d first_normal;
  double first_height_m = 0;
  for (int frame = 1; frame <= 5; ++frame) {
    Vector3d origin;
    Eigen::Quaterniond world_from_camera;
    poses >> origin.x() >> origin.y() >> origin.z() >> world_from_camera.x() >> world_from_camera.y() >>
        world_from_camera.z() >> world_from_camera.w();
    ASSERT_TRUE(poses);
    const DepthFile file = read_depth_file(depth_of(frame), kinect());
    const RepairedPlanes found =
        replace_planes(file.frame, {.tolerance_m = 0.005, .tolerance_relative = 0.01});
    ASSERT_FALSE(found.planes.empty());
    const Vector3d inverse = found.planes[0].inverse;  // the floor is the largest in all of them
    const Vector3d normal = world_from_camera.normalized() * inverse.normalized();
    const double height_m = 1 / inverse.norm() + normal.dot(origin);
    if (frame == 1) {
      first_normal = normal;
      first_height_m = height_m;
    }
    RecordProperty(
        "tilt_mdeg_" + std::to_string(frame),
        static_cast<int>(1e3 * std::acos(std::min(1.0, normal.dot(first_normal))) * 180 / std::numbers::pi));
    RecordProperty("height_mm_" + std::to_string(frame), static_cast<int>(1e3 * (height_m - first_height_m)));
    EXPECT_LT(std::acos(std::min(1.0, normal.dot(first_normal))) * 180 / std::numbers::pi, 3) << frame;
    EXPECT_NEAR(height_m, first_height_m, 0.1) << frame;  // frames agree within 3 to 10 cm
  }
}

}  // namespace
}  // namespace seamline::sensors
