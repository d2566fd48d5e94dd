// Five Kinect frames of a room: one's depth in another's camera, by their poses.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "registration/mesh/register_by_mesh.h"
#include "registration/points/register_by_points.h"
#include "registration/pose/pose.h"
#include "sensors/files/depth_file.h"
#include "sensors/rig/rig.h"
#include "tests/real_data.h"

namespace seamline::registration {
namespace {

struct RealFrame {
  sensors::DepthFrame depth;
  Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
};

std::vector<RealFrame> real_frames(const std::filesystem::path& folder) {
  sensors::DepthFileForm form;
  form.camera.fx_px = 518;
  form.camera.fy_px = 519;
  form.camera.cx_px = 326;  // 325.5 where the first pixel's centre is 0
  form.camera.cy_px = 254;
  form.metres_per_step = 0.001;
  std::ifstream poses(folder / "slambook_pose.txt");
  std::vector<RealFrame> frames;
  for (int number = 1; number <= 5; ++number) {
    RealFrame frame;
    frame.depth =
        sensors::read_depth_file(folder / ("slambook_depth_" + std::to_string(number) + ".pgm"), form).frame;
    double x = 0, y = 0, z = 0, qx = 0, qy = 0, qz = 0, qw = 1;
    poses >> x >> y >> z >> qx >> qy >> qz >> qw;
    frame.world_from_camera.linear() = Eigen::Quaterniond(qw, qx, qy, qz).normalized().toRotationMatrix();
    frame.world_from_camera.translation() = Eigen::Vector3d(x, y, z);
    frames.push_back(frame);
  }
  return frames;
}

/// Median of the distance between what one frame says, registered into the other, and what that one measured;
/// and of how many pixels.
struct Disagreement {
  double median_m = 0;
  std::size_t pixels = 0;
};

Disagreement disagreement(const RegisteredFrame& registered, const sensors::DepthFrame& measured) {
  std::vector<double> differences_m;
  for (std::size_t i = 0; i < measured.depth_m.size(); ++i)
    if (registered.filled[i] != 0 && !sensors::DepthFrame::is_hole(measured.depth_m[i]))
      differences_m.push_back(
          static_cast<double>(std::abs(registered.frame.depth_m[i] - measured.depth_m[i])));
  if (differences_m.empty()) return {};
  const auto middle = differences_m.begin() + static_cast<std::ptrdiff_t>(differences_m.size() / 2);
  std::nth_element(differences_m.begin(), middle, differences_m.end());
  return {*middle, differences_m.size()};
}

TEST(RealFrames, NeighboursAgreeWithinTwelveCentimetresByBothWays) {
  SKIP_WITHOUT_REAL_DATA();
  const std::vector<RealFrame> frames = real_frames(test::real_data() / "rgbd");
  for (std::size_t depth = 0; depth < 5; ++depth)
    for (std::size_t colour = 0; colour < 5; ++colour) {
      if (depth + 1 != colour && colour + 1 != depth) continue;
      const Eigen::Isometry3d colour_from_depth =
          frames[colour].world_from_camera.inverse() * frames[depth].world_from_camera;
      const sensors::PinholeCamera& camera = frames[colour].depth.camera;
      const Disagreement mesh = disagreement(
          register_by_mesh(frames[depth].depth, colour_from_depth, camera, {.jumps = Jumps::cut}),
          frames[colour].depth);
      const Disagreement points = disagreement(
          register_by_points(frames[depth].depth, colour_from_depth, camera), frames[colour].depth);
      EXPECT_GT(mesh.pixels, 70000U);
      EXPECT_LT(mesh.median_m, 0.12);
      EXPECT_LT(points.median_m, 0.12);
    }
}

}  // namespace
}  // namespace seamline::registration
