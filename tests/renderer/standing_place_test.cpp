// What a view says before anything is rendered: where something can stand, where the floor is.
#include "composites/view/standing_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "composites/objects/placing.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "shapes.h"

namespace seamline::renderer {
namespace {

using StandingMeshes = std::vector<std::shared_ptr<const SurfaceMesh>>;
constexpr double room_floor_m = -1.5, room_wall_m = -4;

/// A floor, a table's top over it, and a wall behind both, as a depth map knows them.
class StandingPlace : public testing::Test {
 protected:
  StandingPlace() : depth_(mesh(), Rgb::Constant(0.5F)) {
    camera_.width_px = 96;
    camera_.height_px = 64;
  }
  static DepthMesh mesh() {
    const StandingMeshes room = {test::floor(static_cast<float>(room_floor_m), 20),
                                 test::box({-9, -3, room_wall_m - 1}, {9, 9, room_wall_m}, 0.5F),
                                 test::box({1, -0.9F, -3}, {2, -0.8F, -2}, 0.5F)};
    return build_depth_mesh(capture_depth(Geometry(room), 1024, 0, 2), {.threads = 2});
  }
  Camera camera_;
  Geometry depth_;
};

TEST_F(StandingPlace, BelowAWallInTheMiddleTheFloorThatTheViewShows) {
  const auto place = place_in_view(camera_, depth_, {0, 1, 0});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->place_m.y(), room_floor_m + 1, 0.02)
      << "in the world, whose origin is 1 m below the camera";
  EXPECT_NEAR(place->place_m.z(), room_wall_m, 0.1) << "where it meets the wall";
  EXPECT_GT(place->down, 0.5);
  Camera level = camera_;
  level.tan_half_horizontal = 0.2F;  // shows the wall alone
  const auto on_wall = place_in_view(level, depth_, Eigen::Vector3d::Zero());
  ASSERT_TRUE(on_wall);
  EXPECT_NEAR(on_wall->place_m.z(), room_wall_m, 0.02);
  EXPECT_NEAR(on_wall->normal.z(), 1, 1e-3);
}

TEST_F(StandingPlace, TheFloorIsTheLowestLevelNotTheTable) {
  camera_.axes.col(1) = Eigen::Vector3f(0, 0.9F, -0.436F).normalized();  // looks down
  camera_.axes.col(2) = Eigen::Vector3f(0, 0.436F, 0.9F).normalized();
  const auto floor = floor_in_view(camera_, depth_, {0, 1, 0});
  ASSERT_TRUE(floor);
  EXPECT_NEAR(floor->height_m, room_floor_m + 1, 0.01);
  EXPECT_GT(floor->share, 0.05);
  EXPECT_GT(floor->nearest_m, 1.5);
  const StandingMeshes ball = {test::sphere({0, -1.2F, -3.5F}, 0.3F, 32, 0.5F, 1)};
  const Geometry object(ball);
  const auto count = [](const std::vector<std::uint8_t>& lines) {
    return std::count(lines.begin(), lines.end(), 1);
  };
  const auto open = floor_grid(camera_, depth_, nullptr, *floor, {0, 1, 0}, 0.5, 2),
             hidden = floor_grid(camera_, depth_, &object, *floor, {0, 1, 0}, 0.5, 1);
  EXPECT_GT(count(open), 30);
  EXPECT_LT(count(hidden), count(open));
}

TEST_F(StandingPlace, ObjectsWithoutAPlaceStandSideBySideAndOthersStay) {
  std::vector<PlacedModel> objects(3);
  objects[1].position_m = {7, 8, 9};
  objects[0].has_place = objects[2].has_place = false;
  const auto said = stand_in_view(objects, {0.1, 0.1, 0.1}, camera_, depth_, Eigen::Vector3d::Zero());
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(objects[1].position_m, Eigen::Vector3d(7, 8, 9));
  EXPECT_NEAR(objects[0].position_m.y(), room_floor_m, 0.02);
  EXPECT_NEAR(objects[2].position_m.y(), room_floor_m, 0.02);
  EXPECT_GT((objects[0].position_m - objects[2].position_m).norm(), 0.3);
  EXPECT_TRUE(objects[0].has_place);
  const Geometry nothing{std::span<const std::shared_ptr<const SurfaceMesh>>{}};
  objects[0].has_place = false;
  EXPECT_TRUE(stand_in_view(objects, {0.1, 0.1, 0.1}, camera_, nothing, Eigen::Vector3d::Zero()).empty());
  EXPECT_FALSE(objects[0].has_place);
}

}  // namespace
}  // namespace seamline::renderer
