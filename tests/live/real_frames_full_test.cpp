// Five Kinect frames of a room as a recording; their folder is no part of the project.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "live/frame/live_scene.h"
#include "live/recording/loaded_recording.h"
#include "live/tracking/optical_flow.h"
#include "live/tracking/tracker.h"
#include "small_world.h"
#include "support/files/atomic_file.h"
#include "tests/real_data.h"

namespace seamline::live {
namespace {

namespace fs = std::filesystem;

const fs::path kinect = seamline::test::real_data() / "rgbd";

/// The frames copied into a folder of the test, with an index. Their depth is registered already.
fs::path recording_of_kinect(bool with_poses) {
  const fs::path folder = test::fresh_folder(with_poses ? "live-kinect" : "live-kinect-poseless");
  registration::CameraFile cameras;
  sensors::PinholeCamera camera;
  camera.fx_px = 518;
  camera.fy_px = 519;
  camera.cx_px = 326;  // 325.5 where the first pixel's centre is 0
  camera.cy_px = 254;
  cameras.depth = cameras.colour = camera;
  cameras.colour_from_depth = Eigen::Isometry3d::Identity();
  cameras.convention = sensors::DepthConvention::planar;
  cameras.metres_per_step = 0.001;
  write_file_atomically(folder / "camera.toml", registration::camera_file_text(cameras, "Kinect"));
  Recording recording{.folder = folder};
  recording.up = with_poses ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(0, 1, 0);
  std::ifstream poses(kinect / "slambook_pose.txt");
  for (int number = 1; number <= 5; ++number) {
    RecordedFrame frame{.time_s = 0.5 * number,
                        .depth_file = "slambook_depth_" + std::to_string(number) + ".pgm",
                        .colour_file = "slambook_color_" + std::to_string(number) + ".png"};
    for (const std::string& name : {frame.depth_file, frame.colour_file})
      fs::copy_file(kinect / name, folder / name);
    double x = 0, y = 0, z = 0, qx = 0, qy = 0, qz = 0, qw = 1;
    poses >> x >> y >> z >> qx >> qy >> qz >> qw;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::Quaterniond(qw, qx, qy, qz).normalized().toRotationMatrix();
    pose.translation() = Eigen::Vector3d(x, y, z);
    if (with_poses) frame.world_from_colour = pose;
    recording.frames.push_back(frame);
  }
  write_file_atomically(folder / recording_index, recording_text(recording));
  return folder;
}

TEST(RealFrames, HidePartOfAVirtualBoxAndTakeItsShadow) {
  SKIP_WITHOUT_REAL_DATA();
  const LoadedRecording recording = load_recording(read_recording(recording_of_kinect(true)), {});
  ASSERT_EQ(recording.frames.size(), 5U);
  std::size_t holes = 0;
  for (const float depth_m : recording.frames[0].depth.depth_m) holes += std::isinf(depth_m) ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(holes) / (640 * 480), 0.32, 0.01);
  const Eigen::Isometry3d first = first_pose(recording);
  // A box through what the middle of the picture shows: its front is seen, its back is hidden.
  const DepthPoints points(recording.rig.depth_form, recording.rig.colour_from_depth, 2);
  const std::size_t middle = 240 * 640 + 320;
  ASSERT_TRUE(std::isfinite(recording.frames[0].depth.depth_m[middle]));
  const Eigen::Vector3d centre_m =
      first * points.point_m(middle, recording.frames[0].depth.depth_m[middle]) - first.translation();
  const Eigen::Vector3d half_m(0.15, 0.15, 0.15);
  LivePipeline pipeline(
      recording, test::scene_with(recording, {test::box("box", centre_m - half_m, centre_m + half_m, 0.8F)}),
      first.translation(), {});
  for (const Mapping mapping : {Mapping::points, Mapping::mesh}) {
    const LiveFrame& frame = pipeline.compose(recording.frames[0], first, {.mapping = mapping});
    const auto covered = [&] {
      return std::count(frame.eyes[0].covered.begin(), frame.eyes[0].covered.end(), 1);
    };
    const auto with_test = covered();
    const auto alone = [&] {
      (void)pipeline.compose(recording.frames[0], first,
                             {.mapping = mapping, .occlusion = Occlusion::nobody});
      return covered();
    }();
    EXPECT_GT(with_test, 500);
    EXPECT_GT(alone, with_test + 500);
  }
}

TEST(RealFrames, FeaturesAreFollowedOnlyWhereFramesOverlap) {
  SKIP_WITHOUT_REAL_DATA();
  if (!has_optical_flow()) GTEST_SKIP() << "built without OpenCV's video part";
  const LoadedRecording recording = load_recording(read_recording(recording_of_kinect(false)), {});
  EXPECT_FALSE(recording.has_poses());
  Tracker tracker(recording, Tracking::features, 0.16, 2);
  for (std::size_t i = 0; i < recording.frames.size(); ++i) {
    const TrackedPose pose = tracker.track(i);
    EXPECT_TRUE(pose.world_from_colour.matrix().allFinite());
    EXPECT_TRUE(pose.is_found || pose.features == 0);
  }
}

}  // namespace
}  // namespace seamline::live
