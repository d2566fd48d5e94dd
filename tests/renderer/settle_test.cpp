// Objects that are let down, and what is refused.
#include "physics/settle.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "falling_bodies.h"
#include "physics/body_shape.h"
#include "raytracer/scene/resting_object.h"
#include "raytracer/scene/truth_scene.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

using renderer::BallShape;
using renderer::BodyShape;
using renderer::Ground;
using renderer::HullShape;
using renderer::PhysicsSettings;
using renderer::settle;
using test::box_hull;
using test::flat_floor;
using test::pose_at;

std::vector<Eigen::Vector3d> ball_points(double radius_m, const Eigen::Vector3d& centre_m) {
  std::vector<Eigen::Vector3d> points;
  for (int row = 0; row <= 40; ++row)
    for (int column = 0; column < 80; ++column) {
      const double polar = std::numbers::pi * row / 40, around = 2 * std::numbers::pi * column / 80;
      points.emplace_back(centre_m + radius_m * Eigen::Vector3d(std::sin(polar) * std::cos(around),
                                                                std::cos(polar),
                                                                std::sin(polar) * std::sin(around)));
    }
  return points;
}

TEST(BodyShape, ABallIsABallAndACubeIsNone) {
  const BodyShape ball = renderer::body_shape_of(ball_points(0.3, {1, 2, 3}), "object");
  ASSERT_TRUE(std::holds_alternative<BallShape>(ball));
  EXPECT_NEAR(std::get<BallShape>(ball).radius_m, 0.3, 1e-3);
  EXPECT_LT((std::get<BallShape>(ball).centre_m - Eigen::Vector3d(1, 2, 3)).norm(), 1e-3);
  const BodyShape cube = renderer::body_shape_of(test::box_corners({0.1, 0.1, 0.1}), "object");
  ASSERT_TRUE(std::holds_alternative<HullShape>(cube));
  EXPECT_EQ(std::get<HullShape>(cube).points_m.size(), 8U);
}

TEST(BodyShape, WhatIsFlatIsRefused) {
  EXPECT_THAT(test::complaint_of([] {
                (void)renderer::body_shape_of(test::box_corners({0.1, 0, 0.1}), "--object");
              }),
              testing::HasSubstr("--object"));
}

TEST(Settle, ATiltedBoxFallsOntoAFace) {
  SKIP_WITHOUT_BULLET();
  const Eigen::Vector3d half_m(0.1, 0.06, 0.14);
  const renderer::Settled settled =
      settle(flat_floor(8), box_hull(half_m), pose_at({0, 0.4, 0}, 0.5), {}, "box");
  const double height_m = settled.world_from_body.translation().y();
  const double to_a_face = (half_m.array() - height_m).abs().minCoeff();
  EXPECT_LT(to_a_face, 2 * PhysicsSettings{}.margin_m);
  EXPECT_GT(settled.turned_deg, 10);
}

TEST(Settle, WhatCannotRestIsRefusedInOneSentence) {
  SKIP_WITHOUT_BULLET();
  const Ground floor = flat_floor(4);
  const BallShape ball;
  EXPECT_THAT(test::complaint_of([&] {
                (void)settle(floor, ball, pose_at({3, 1, 0}), {}, "ball");
              }),
              testing::HasSubstr("falls out of the scene"));
  EXPECT_THAT(test::complaint_of([&] {
                (void)settle(floor, ball, pose_at({0, 0.03, 0}), {}, "ball");
              }),
              testing::AllOf(testing::HasSubstr("m into the surface at 0.00 0.00 0.00: "),
                             testing::HasSubstr("let go of it higher")));
  const Ground bowl = test::floor_of(40, 2, 0, [](double x, double z) { return x * x + z * z; });
  PhysicsSettings slippery;
  slippery.friction = slippery.rolling_friction_m = 0;
  EXPECT_THAT(test::complaint_of([&] {
                (void)settle(bowl, ball, pose_at({0.5, 0.6, 0}), slippery, "ball");
              }),
              testing::HasSubstr("still moves"));
}

TEST(Settle, InsideOfAThingIsRefused) {
  SKIP_WITHOUT_BULLET();
  // A closed box of 2 m, wound outwards, with a ball in its middle that touches nothing.
  Ground thing;
  thing.vertices_m = test::box_corners({1, 1, 1});
  thing.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  EXPECT_THAT(test::complaint_of([&] {
                (void)settle(thing, BallShape{}, pose_at({0, 0, 0}), {}, "ball");
              }),
              testing::HasSubstr("backs of surfaces"));
  Ground room = thing;
  for (auto& corners : room.triangles) std::swap(corners[0], corners[1]);
  EXPECT_NEAR(settle(room, BallShape{}, pose_at({0, 0, 0}), {}, "ball").world_from_body.translation().y(),
              -0.9, 1e-3);
}

TEST(RestingObject, KeepsItsScaleAndStandsOnTheGround) {
  SKIP_WITHOUT_BULLET();
  renderer::SceneFile file;
  file.meshes.emplace_back();
  file.meshes[0].positions_m = test::box_corners({1, 1, 1});
  const ObjectDefinition object{.name = "cube",
                                .file = {},
                                .path = {},
                                .position_m = {0.1, 0.5, 0.2},
                                .rotation_deg = {0, 30, 0},
                                .scale = 0.15};
  const renderer::RestingObject at_rest =
      renderer::rested(file, renderer::object_placement(object), flat_floor(6), "cube");
  EXPECT_NEAR(std::cbrt(at_rest.placement.linear().determinant()), 0.15, 1e-9);
  EXPECT_NEAR(at_rest.placement.translation().y(), 0.15, 2 * PhysicsSettings{}.margin_m);
  const Eigen::Vector3d turn = renderer::rotation_deg_of(at_rest.settled.world_from_body.linear());
  EXPECT_NEAR(turn.y(), 30, 5);
}

TEST(RestingObject, AnglesAreThoseOfPlacements) {
  for (const Eigen::Vector3d& turn :
       {Eigen::Vector3d(10, 20, 30), Eigen::Vector3d(-80, 170, -100), Eigen::Vector3d(0, 0, 0)}) {
    const ObjectDefinition object{.name = {}, .file = {}, .path = {}, .rotation_deg = turn};
    EXPECT_LT((renderer::rotation_deg_of(renderer::object_placement(object).linear()) - turn).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace seamline
