// A body on depth frames: how much it shakes, and what makes it shake less.
#include "laboratory/settling/shake.h"

#include <gtest/gtest.h>

#include "falling_bodies.h"
#include "laboratory/settling/frame_ground.h"
#include "sensors/noise/measurement.h"
#include "sensors/repair/planes.h"

namespace seamline {
namespace {

using renderer::Fall;
using renderer::FallRequest;
using renderer::FrameGround;
using sensors::DepthFrame;

/// A camera 1 m above a floor that looks straight down: its frame is x right, y down, z forward.
sensors::PinholeCamera camera() {
  return {.width_px = 32,
          .height_px = 24,
          .fx_px = 30,
          .fy_px = 30,
          .cx_px = 16,
          .cy_px = 12,
          .skew_px = 0,
          .distortion = {}};
}

Eigen::Isometry3d looking_down() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  pose.translation() = Eigen::Vector3d(0, 1, 0);
  return pose;
}

sensors::SeenFrame seen_floor() {
  sensors::SeenFrame seen;
  seen.camera = camera();
  for (int row = 0; row < seen.camera.height_px; ++row)
    for (int column = 0; column < seen.camera.width_px; ++column) {
      const auto direction = sensors::direction_through(seen.camera, {column + 0.5, row + 0.5});
      seen.radial_m.push_back(static_cast<float>(direction->norm() / direction->z()));
    }
  return seen;
}

DepthFrame measured(double sigma_m, int frame) {
  const sensors::GenericNoise noise{.relative_sigma = sigma_m};
  return sensors::measure(seen_floor(), noise, {1, static_cast<std::uint64_t>(frame)}, sigma_m > 0 ? 1 : 0, 1)
      .frame;
}

FallRequest box_request(const std::string& name) {
  return {.name = name,
          .shape = test::box_hull({0.1, 0.08, 0.1}),
          .world_from_body = test::pose_at({0, 0.1, 0}),
          .world_from_depth = looking_down(),
          .frames_to_rest = 40,
          .frames = 40,
          .physics = {}};
}

Fall fall(const renderer::DepthSequence& depth, const std::string& name) {
  return renderer::fall_on(depth, box_request(name), [] {});
}

TEST(FrameGround, TrianglesAreThoseOfMeasuredPixelsAndHolesKeepTheirDepth) {
  FrameGround ground(looking_down());
  DepthFrame frame = measured(0, 0);
  frame.depth_m[frame.index(3, 3)] = sensors::hole;
  EXPECT_EQ(ground.take(frame), FrameGround::Change::triangles);
  const std::size_t all = 2 * 31 * 23;
  EXPECT_EQ(ground.ground().triangles.size(), all - 6);
  EXPECT_EQ(ground.take(frame), FrameGround::Change::none);
  EXPECT_EQ(ground.take(measured(0, 0)), FrameGround::Change::triangles);
  EXPECT_EQ(ground.ground().triangles.size(), all);
  const Eigen::Vector3d before = ground.ground().vertices_m[frame.index(3, 3)];
  frame.depth_m[frame.index(9, 9)] *= 1.5F;
  EXPECT_EQ(ground.take(frame), FrameGround::Change::moved);
  EXPECT_EQ(ground.ground().vertices_m[frame.index(3, 3)], before);
  EXPECT_NEAR(before.y(), 0, 1e-6);
}

TEST(Shake, PlanesInPlaceOfNoiseShakeLess) {
  SKIP_WITHOUT_BULLET();
  constexpr double sigma_m = 0.004;
  const Fall noisy = fall([](int frame) { return measured(sigma_m, frame); }, "measured");
  const Fall planes = fall(
      [](int frame) {
        return sensors::replace_planes(measured(sigma_m, frame), {.tolerance_m = 4 * sigma_m}).repaired.frame;
      },
      "planes");
  const Fall exact = fall([](int) { return measured(0, 0); }, "exact");
  EXPECT_GT(noisy.jump_mm, 0.5);
  EXPECT_LT(planes.jump_mm, 0.25 * noisy.jump_mm);
  EXPECT_LT(planes.shake_mm, noisy.shake_mm);
  EXPECT_LT(exact.jump_mm, 0.25 * planes.jump_mm);
}

TEST(Shake, ABallRestsOnAFittedPlaneWithinTheMargin) {
  SKIP_WITHOUT_BULLET();
  constexpr double sigma_m = 0.004, radius_m = 0.08;
  FrameGround ground(looking_down());
  ground.take(sensors::replace_planes(measured(sigma_m, 0), {.tolerance_m = 5 * sigma_m}).repaired.frame);
  const std::vector<Eigen::Vector3d>& places_m = ground.ground().vertices_m;
  const Eigen::Vector3d across_m = places_m[31] - places_m[0], along_m = places_m[23 * 32] - places_m[0];
  const Eigen::Vector3d normal = along_m.cross(across_m).normalized();
  const renderer::PhysicsSettings settings;
  renderer::RigidWorld world(ground.ground(), renderer::BallShape{.radius_m = radius_m},
                             test::pose_at({0.01, 0.12, 0}), settings);
  test::run(world, 240);
  const double above_m = std::abs(normal.dot(world.body().middle_m - places_m[0]));
  EXPECT_NEAR(above_m, radius_m, 1.01 * settings.margin_m);
  EXPECT_LT(world.body().speed_m_s, 1e-3);
}

TEST(Shake, OnExactDepthThereIsNoneAtAnyNumberOfSteps) {
  SKIP_WITHOUT_BULLET();
  for (const int steps_per_s : {60, 240, 480}) {
    FallRequest request = box_request("exact");
    request.physics.steps_per_s = steps_per_s;
    const Fall exact = renderer::fall_on([](int) { return measured(0, 0); }, request, [] {});
    EXPECT_LT(exact.jump_mm, 1e-3) << steps_per_s << " steps a second";
  }
}

TEST(Shake, TheSameDepthGivesTheSameBits) {
  SKIP_WITHOUT_BULLET();
  const auto depth = [](int frame) { return measured(0.004, frame); };
  const Fall one = fall(depth, "measured"), other = fall(depth, "measured");
  ASSERT_EQ(one.poses.size(), 80U);
  for (std::size_t i = 0; i < one.poses.size(); ++i)
    EXPECT_TRUE(one.poses[i].matrix() == other.poses[i].matrix()) << i;
}

}  // namespace
}  // namespace seamline
