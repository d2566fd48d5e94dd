#include "renderer/depth/capture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "shapes.h"

namespace seamline::renderer {
namespace {

TEST(Capture, SphereRoomHasItsRadiusEverywhere) {
  const Geometry room(std::vector{test::sphere({0, 0, 0}, 7.0F, 1600, 0.5F)});
  const DepthMap map = capture_depth(room, 128, 0, 2);
  for (const float distance : map.distance_m) EXPECT_NEAR(distance / 7.0, 1.0, 1e-5);
}

TEST(Capture, BoxRoomHasTheDistanceOfItsWalls) {
  const Eigen::Vector3f least(-3, -1, -6), most(4, 3, 2);
  const Geometry room(std::vector{test::box(least, most, 0.5F)});
  const DepthMap map = capture_depth(room, 256, 0, 2);
  for (int row = 0; row < map.height_px; ++row)
    for (int column = 0; column < map.width_px; ++column) {
      const Eigen::Vector3d d = panorama_direction(column + 0.5, row + 0.5, map.width_px, map.height_px);
      double expected = 1e30;
      for (int axis = 0; axis < 3; ++axis)
        expected = std::min(expected, (d[axis] > 0 ? most[axis] : least[axis]) / d[axis]);
      EXPECT_NEAR(map.at(column, row) / expected, 1.0, 1e-5);
    }
}

TEST(Capture, SkyIsAHole) {
  const Geometry floor(std::vector{test::floor(-1, 20)});
  const DepthMap map = capture_depth(floor, 64, 0, 1);
  EXPECT_TRUE(std::isinf(map.at(10, 0)));
  EXPECT_FALSE(std::isinf(map.at(10, 31)));
}

TEST(Capture, YawTurnsTheGrid) {
  const Geometry room(std::vector{test::box({-3, -1, -6}, {4, 3, 2}, 0.5F)});
  const DepthMap plain = capture_depth(room, 64, 0, 1), turned = capture_depth(room, 64, 5, 1);
  for (int row = 0; row < 32; ++row)
    for (int column = 0; column < 64; ++column)
      EXPECT_NEAR(turned.at(column, row), plain.at((column + 5) % 64, row), 1e-4);
}

}  // namespace
}  // namespace seamline::renderer
