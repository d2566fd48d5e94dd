#include <gtest/gtest.h>

#include "renderer/depth/dense_sphere.h"
#include "tests/renderer/depth_mesh_laws.h"

namespace seamline::renderer {
namespace {

using test::hole;
using test::make_map;

TEST(DenseSphere, HasASizeOfItsOwnBelow2048) {
  for (const int width : {2, 64, 426, 2046}) {
    const DenseSphere sphere = make_dense_sphere(make_map(width, [](int, int) { return 1; }), 0, 1);
    EXPECT_EQ(sphere.width, 2048);
    EXPECT_EQ(sphere.height, 1024);
  }
  EXPECT_EQ(make_dense_sphere(make_map(2050, [](int, int) { return 1; }), 0, 1).width, 2050);
}

TEST(DenseSphere, HitsTexelsExactlyAtEqualWidth) {
  const DepthMap map = make_map(2048, [](int column, int row) { return 1 + column + 0.001 * row; });
  const DenseSphere sphere = make_dense_sphere(map, 0, 1);
  EXPECT_EQ(sphere.distance_m.data(), map.distance_m.data());
  EXPECT_LT((sphere.direction(17, 100) - panorama_direction(100.5, 17.5, 2048, 1024)).norm(), 1e-15);
}

TEST(DenseSphere, InterpolatesBilinearly) {
  // Four vertices a texel: vertex i lies at (i + 0.5) / 4 - 0.5 texel centres.
  const DepthMap map = make_map(512, [](int column, int row) { return 1 + column * column + 3 * row; });
  const DenseSphere sphere = make_dense_sphere(map, 0, 1);
  const auto f = [&](int column, int row) { return static_cast<double>(map.at(column, row)); };
  const auto bilinear = [&](int c, double u, int r, double v) {
    return (1 - v) * ((1 - u) * f(c, r) + u * f((c + 1) % 512, r)) +
           v * ((1 - u) * f(c, r + 1) + u * f((c + 1) % 512, r + 1));
  };
  EXPECT_FLOAT_EQ(sphere.at(42, 402), static_cast<float>(bilinear(100, 0.125, 10, 0.125)));
  EXPECT_FLOAT_EQ(sphere.at(43, 405), static_cast<float>(bilinear(100, 0.875, 10, 0.375)));
  // Across the seam, from texel 511 to texel 0.
  EXPECT_FLOAT_EQ(sphere.at(42, 2047), static_cast<float>(bilinear(511, 0.375, 10, 0.125)));
  EXPECT_FLOAT_EQ(sphere.at(42, 0), static_cast<float>(bilinear(511, 0.625, 10, 0.125)));
  // Rows are clamped at the poles.
  EXPECT_FLOAT_EQ(sphere.at(0, 402), static_cast<float>(0.875 * f(100, 0) + 0.125 * f(101, 0)));
  EXPECT_FLOAT_EQ(sphere.at(1023, 402), static_cast<float>(0.875 * f(100, 255) + 0.125 * f(101, 255)));
}

TEST(DenseSphere, HolesAreNearestAndWeightsRenormalised) {
  const DepthMap map =
      make_map(512, [](int column, int row) { return column == 100 && row == 50 ? hole : 2.0 + column; });
  const DenseSphere sphere = make_dense_sphere(map, 0, 1);
  int holes = 0;
  for (int row = 0; row < 1024; ++row)
    for (int column = 0; column < 2048; ++column)
      if (is_hole(sphere.at(row, column))) {
        ++holes;
        EXPECT_EQ(row / 4, 50);
        EXPECT_EQ(column / 4, 100);
      }
  EXPECT_EQ(holes, 16);
  // Just left of the hole, in its row: texels 99 (weight 5/8) and 100 (the hole) of rows 50 (7/8) and 51
  // (1/8).
  const double wanted = (0.875 * 0.625 * 101 + 0.125 * (0.625 * 101 + 0.375 * 102)) / (1 - 0.875 * 0.375);
  EXPECT_FLOAT_EQ(sphere.at(202, 399), static_cast<float>(wanted));
}

TEST(DenseSphere, PolesAreMeansOfTheirRows) {
  const DepthMap map = make_map(512, [](int column, int row) {
    if (row == 0) return column % 2 == 0 ? 1.0F : 3.0F;
    return row == 255 && column != 7 ? hole : 5.0F;
  });
  const DenseSphere sphere = make_dense_sphere(map, 0, 1);
  EXPECT_FLOAT_EQ(sphere.zenith_m, 2);
  EXPECT_FLOAT_EQ(sphere.nadir_m, 5);  // of the valid ones
  const DepthMap sky = make_map(512, [](int, int row) { return row == 0 ? hole : 1.0F; });
  EXPECT_TRUE(is_hole(make_dense_sphere(sky, 0, 1).zenith_m));
}

TEST(DenseSphere, YawTurnsDirectionsToTheRight) {
  const DepthMap map = make_map(512, [](int, int) { return 1; });
  for (const double yaw : {1.0, 128.0, -5.0, 512.0, 513.0, 0.5, -0.25, 511.75}) {
    const DenseSphere sphere = make_dense_sphere(map, yaw, 1);
    // Dense column 4 c + 2 begins the right half of texel c.
    const Eigen::Vector3d wanted = panorama_direction(4 * (100 + yaw) + 2.5, 300.5, 2048, 1024);
    EXPECT_LT((sphere.direction(300, 402) - wanted).norm(), 1e-12) << yaw;
  }
}

TEST(DenseSphere, IsTheSameForAnyNumberOfThreads) {
  std::mt19937_64 random(3);
  const DepthMap map = test::random_map(100, random);
  EXPECT_EQ(make_dense_sphere(map, 0, 1).resampled_m, make_dense_sphere(map, 0, 5).resampled_m);
}

}  // namespace
}  // namespace seamline::renderer
