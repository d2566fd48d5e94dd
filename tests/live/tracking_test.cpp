// Poses that pictures give, against planted ones.
#include <gtest/gtest.h>

#include <numbers>

#include "laboratory/figures/marker_scene.h"
#include "live/tracking/optical_flow.h"
#include "live/tracking/tracker.h"
#include "registration/calibration/aruco.h"
#include "small_world.h"
#include "support/text/error.h"

namespace seamline::live {
namespace {

struct PoseError {
  double angle_deg = 0, place_m = 0;
};
PoseError error_of(const Eigen::Isometry3d& found, const Eigen::Isometry3d& planted) {
  const Eigen::Isometry3d off = planted.inverse() * found;
  return {Eigen::AngleAxisd(off.linear()).angle() * 180 / std::numbers::pi, off.translation().norm()};
}

TEST(Tracking, FeaturesFollowAPlantedOrbitWithinTwoCentimetresAndHalfADegree) {
  if (!has_optical_flow()) GTEST_SKIP() << "built without OpenCV's video part";
  LoadedRecording recording = test::recorded(
      test::patched_room(), test::exact_rig(320, 240), test::definition_of(1),
      {.kind = PathKind::orbit, .centre_m = Eigen::Vector3d(0, 0, -4), .angle_deg = 8}, 12, 16);
  std::vector<Eigen::Isometry3d> planted;
  for (LoadedFrame& frame : recording.frames) planted.push_back(*frame.world_from_colour);
  for (LoadedFrame& frame : recording.frames) frame.world_from_colour.reset();
  EXPECT_FALSE(recording.has_poses());
  Tracker tracker(recording, Tracking::features, 0.16, 2), again(recording, Tracking::features, 0.16, 1);
  for (std::size_t i = 0; i < recording.frames.size(); ++i) {
    const TrackedPose pose = tracker.track(i);
    EXPECT_TRUE(pose.is_found);
    EXPECT_GE(pose.features, 100);
    // Without poses the world is the first camera's own, which here is the planted one.
    const PoseError error = error_of(pose.world_from_colour, planted[i]);
    EXPECT_LT(error.place_m, 0.02) << "frame " << i;
    EXPECT_LT(error.angle_deg, 0.5) << "frame " << i;
    EXPECT_EQ(again.track(i).world_from_colour.matrix(), pose.world_from_colour.matrix())
        << "the same for any number of threads";
  }
  EXPECT_GT(error_of(planted.back(), planted.front()).place_m, 0.4) << "there was something to follow";
}

TEST(Tracking, AMarkerGivesPlantedPosesWithinTwoCentimetresAndADegree) {
  if (!registration::has_aruco()) GTEST_SKIP() << "built without OpenCV's ArUco";
  const auto folder = test::fresh_folder("live-marker");
  renderer::write_marker_scene(folder / "marker.glb", {.side_m = 0.3, .camera_m = 1.2});
  const renderer::SceneFile file = renderer::read_scene_file(folder / "marker.glb");
  const sensors::Rig rig = test::exact_rig(640, 480);
  LoadedRecording recording = test::recorded(
      file, rig, test::definition_of(1),
      {.kind = PathKind::orbit, .centre_m = Eigen::Vector3d(0, 0, -1.2), .angle_deg = 30}, 3, 4);
  const Eigen::Vector3d camera_m(0, 0, 1.2);  // the file's camera; the marker's middle is the origin
  Tracker tracker(recording, Tracking::marker, 0.3, 2);
  for (std::size_t i = 0; i < recording.frames.size(); ++i) {
    Eigen::Isometry3d planted = *recording.frames[i].world_from_colour;
    planted.translation() += camera_m;
    const TrackedPose pose = tracker.track(i);
    EXPECT_TRUE(pose.is_found);
    const PoseError error = error_of(pose.world_from_colour, planted);
    EXPECT_LT(error.place_m, 0.02) << "frame " << i;
    EXPECT_LT(error.angle_deg, 1) << "frame " << i;
  }
}

TEST(Tracking, WithoutPosesTheRecordedWayIsRefused) {
  LoadedRecording recording = test::recorded(test::room(), test::exact_rig(32, 24), test::definition_of(1),
                                             {.kind = PathKind::still}, 1, 1);
  EXPECT_NO_THROW(require_tracking(Tracking::recorded, recording, "--track"));
  recording.frames[0].world_from_colour.reset();
  EXPECT_THROW(require_tracking(Tracking::recorded, recording, "--track"), InputError);
}

}  // namespace
}  // namespace seamline::live
