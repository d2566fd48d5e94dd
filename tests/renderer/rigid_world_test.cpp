// Laws of bodies that fall: where they rest, when they slide, that energy does not grow.
#include "physics/rigid_world.h"

#include <gtest/gtest.h>

#include <bit>

#include "falling_bodies.h"

namespace seamline {
namespace {

using renderer::BallShape;
using renderer::BodyState;
using renderer::Ground;
using renderer::PhysicsSettings;
using renderer::RigidWorld;
using test::box_hull;
using test::flat_floor;
using test::pose_at;
using test::run;

constexpr int second = 240;
constexpr double g = 9.81;

TEST(RigidWorld, FallsAsGalileoSays) {
  SKIP_WITHOUT_BULLET();
  RigidWorld world(flat_floor(1), BallShape{}, pose_at({0, 10, 0}), {});
  run(world, second);
  // Steps of h fall g t (t + h) / 2.
  EXPECT_NEAR(world.body().middle_m.y(), 10 - 0.5 * g * (1 + 1.0 / second), 1e-9);
  EXPECT_NEAR(world.body().speed_m_s, g, 1e-9);
}

TEST(RigidWorld, ABallRestsAtItsRadius) {
  SKIP_WITHOUT_BULLET();
  const PhysicsSettings settings;
  for (const int cells : {1, 7, 50})
    for (const double radius_m : {0.05, 0.1, 0.5}) {
      RigidWorld world(flat_floor(cells), BallShape{.radius_m = radius_m},
                       pose_at({0.013, 1.5 * radius_m, 0.02}), settings);
      run(world, 3 * second);
      EXPECT_NEAR(world.body().middle_m.y(), radius_m, 1.001 * settings.margin_m) << cells << " cells";
    }
}

TEST(RigidWorld, ABoxRestsOnItsFace) {
  SKIP_WITHOUT_BULLET();
  const PhysicsSettings settings;
  for (const int cells : {1, 20, 60}) {
    RigidWorld world(flat_floor(cells), box_hull({0.1, 0.07, 0.12}), pose_at({0.01, 0.1, 0.02}), settings);
    run(world, 2 * second);
    EXPECT_NEAR(world.body().middle_m.y(), 0.07, 2 * settings.margin_m) << cells << " cells";
    EXPECT_GT(world.body().world_from_body.linear()(1, 1), 0.99999) << cells << " cells";
  }
}

TEST(RigidWorld, ATallBoxStandsStillOnManySmallTriangles) {
  SKIP_WITHOUT_BULLET();
  const int frame = second / 30;
  RigidWorld world(test::flat_floor(30, 0.5), box_hull({0.1, 0.3, 0.1}), pose_at({0.003, 0.301, 0.002}), {});
  run(world, second / 2);
  for (int i = 0; i < 15; ++i) {
    const Eigen::Vector3d before_m = world.body().middle_m;
    run(world, frame);
    EXPECT_LT((world.body().middle_m - before_m).norm(), 1e-5) << "frame " << i;
  }
}

TEST(RigidWorld, AFastBallDoesNotGoThroughTheGround) {
  SKIP_WITHOUT_BULLET();
  // At 9.9 m/s it moves by twice its size in a step.
  const PhysicsSettings settings;
  RigidWorld world(flat_floor(7), BallShape{.radius_m = 0.01}, pose_at({0.1, 5, 0.1}), settings);
  run(world, 3 * second);
  EXPECT_NEAR(world.body().middle_m.y(), 0.01, 1.001 * settings.margin_m);
}

TEST(RigidWorld, ABoxStaysUnderTheFrictionAngleAndSlidesOverIt) {
  SKIP_WITHOUT_BULLET();
  const PhysicsSettings settings;
  const double limit_rad = std::atan(settings.friction);
  for (const double share : {0.5, 0.9, 1.1, 1.3})
    for (const int cells : {1, 20}) {
      const double tilt_rad = share * limit_rad;
      const Ground slope = test::floor_of(cells, 8, tilt_rad, [](double, double) { return 0.0; });
      const Eigen::Vector3d up(-std::sin(tilt_rad), std::cos(tilt_rad), 0);
      RigidWorld world(slope, box_hull({0.2, 0.1, 0.2}), pose_at(0.101 * up, tilt_rad), settings);
      run(world, second);
      const Eigen::Vector3d after_one = world.body().middle_m;
      run(world, second);
      const double slid_m = (world.body().middle_m - after_one).norm();
      // From rest: a t^2 / 2 between the first and the second second.
      const double pull_m_s2 = g * (std::sin(tilt_rad) - settings.friction * std::cos(tilt_rad));
      const std::string where =
          std::to_string(share) + " of the friction angle, " + std::to_string(cells) + " cells";
      if (share < 1)
        EXPECT_LT(slid_m, 1e-3) << where;
      else
        EXPECT_NEAR(slid_m, 1.5 * pull_m_s2, 0.15 * 1.5 * pull_m_s2) << where;
    }
}

TEST(RigidWorld, EnergyNeverGrows) {
  SKIP_WITHOUT_BULLET();
  const PhysicsSettings settings;
  // What Bullet lifts a body out of the ground by: less than the margin.
  const double rounding_j_kg = g * settings.margin_m;
  const Ground waves =
      test::floor_of(24, 3, 0.1, [](double x, double z) { return 0.03 * std::sin(7 * x) * std::cos(5 * z); });
  for (const renderer::BodyShape& shape :
       {renderer::BodyShape(BallShape{}), renderer::BodyShape(box_hull({0.1, 0.05, 0.15}))}) {
    RigidWorld world(waves, shape, pose_at({0.2, 0.5, 0.1}, 0.4), settings);
    double before = world.body().energy_j_kg;
    const double start = before;
    for (int i = 0; i < 3 * second; ++i) {
      world.step();
      const double now = world.body().energy_j_kg;
      EXPECT_LE(now, before + rounding_j_kg) << "step " << i;
      before = now;
    }
    EXPECT_LT(before, start - 1);
  }
}

TEST(RigidWorld, TwoRunsGiveTheSameBits) {
  SKIP_WITHOUT_BULLET();
  const auto bits = [] {
    const Ground waves = test::floor_of(
        30, 2, 0, [](double x, double z) { return 0.01 * std::sin(40 * x) * std::sin(31 * z); });
    RigidWorld world(waves, box_hull({0.1, 0.05, 0.15}), pose_at({0.02, 0.3, 0.01}, 0.4), {});
    std::vector<std::uint64_t> out;
    for (int frame = 0; frame < 30; ++frame) {
      Ground moved = waves;
      for (Eigen::Vector3d& vertex_m : moved.vertices_m)
        vertex_m.y() += 1e-3 * std::sin(frame + 50 * vertex_m.x());
      world.move_ground(moved.vertices_m);
      run(world, 8);
      for (const double value : world.body().world_from_body.matrix().reshaped())
        out.push_back(std::bit_cast<std::uint64_t>(value));
    }
    return out;
  };
  EXPECT_EQ(bits(), bits());
}

TEST(RigidWorld, ABodyFollowsTheGroundThatMoves) {
  SKIP_WITHOUT_BULLET();
  const PhysicsSettings settings;
  const Ground floor = flat_floor(10);
  RigidWorld world(floor, box_hull({0.1, 0.1, 0.1}), pose_at({0, 0.11, 0}), settings);
  run(world, 2 * second);
  Ground lower = floor;
  for (Eigen::Vector3d& vertex_m : lower.vertices_m) vertex_m.y() -= 0.3;
  world.move_ground(lower.vertices_m);
  run(world, 3 * second);
  EXPECT_NEAR(world.body().middle_m.y(), -0.2, 2 * settings.margin_m);
  world.set_ground(test::floor_of(1, 0.01, 0, [](double, double) { return 0.0; }));  // above it, and small
  run(world, second);
  EXPECT_LT(world.body().middle_m.y(), -2);
}

}  // namespace
}  // namespace seamline
