// Radial and planar values of one frame stand for the same points.
#include "sensors/frame/depth_frame.h"

#include <gtest/gtest.h>

#include "support/arithmetic/random.h"

namespace seamline::sensors {
namespace {

DepthFrame some_frame(DepthConvention convention) {
  DepthFrame frame;
  frame.camera = {.width_px = 32,
                  .height_px = 24,
                  .fx_px = 30,
                  .fy_px = 31,
                  .cx_px = 15,
                  .cy_px = 13,
                  .skew_px = 0.4,
                  .distortion = {.k1 = -0.1, .k2 = 0.01, .p1 = 0.001, .p2 = 0.002, .k3 = 0}};
  frame.convention = convention;
  Random random(3);
  for (int i = 0; i < 32 * 24; ++i)
    frame.depth_m.push_back(i % 7 == 0 ? hole : static_cast<float>(0.5 + 4 * random.uniform()));
  return frame;
}

TEST(DepthFrame, ConventionsStandForTheSamePoints) {
  for (const auto convention : {DepthConvention::radial, DepthConvention::planar}) {
    const DepthFrame frame = some_frame(convention);
    const auto other =
        convention == DepthConvention::radial ? DepthConvention::planar : DepthConvention::radial;
    const DepthFrame turned = in_convention(frame, other), back = in_convention(turned, convention);
    for (int row = 0; row < 24; ++row)
      for (int column = 0; column < 32; ++column) {
        const auto a = point_of_pixel(frame, column, row), b = point_of_pixel(turned, column, row);
        ASSERT_EQ(a.has_value(), b.has_value());
        if (!a) continue;
        EXPECT_LE((*a - *b).norm(), 1e-6 * a->norm());
        EXPECT_NEAR(back.at(column, row), frame.at(column, row), 1e-6F * frame.at(column, row));
        const auto place = project(frame.camera, *a);
        ASSERT_TRUE(place);
        EXPECT_LE((*place - Eigen::Vector2d(column + 0.5, row + 0.5)).norm(), 1e-6);
      }
  }
}

TEST(DepthFrame, RadialValueIsTheLengthOfTheRayAndPlanarTheDistanceFromThePlane) {
  DepthFrame frame = some_frame(DepthConvention::radial);
  EXPECT_NEAR(point_of_pixel(frame, 30, 20)->norm(), frame.at(30, 20), 1e-6);
  frame.convention = DepthConvention::planar;
  EXPECT_NEAR(point_of_pixel(frame, 30, 20)->z(), frame.at(30, 20), 1e-12);
}

TEST(DepthFrame, WhatIsNoDistanceOrOutOfRangeIsAHoleAndCounted) {
  DepthFrame frame = some_frame(DepthConvention::planar);
  std::fill(frame.depth_m.begin(), frame.depth_m.end(), 2.0F);
  frame.depth_m[0] = 0;
  frame.depth_m[1] = -1;
  frame.depth_m[2] = std::numeric_limits<float>::quiet_NaN();
  frame.depth_m[3] = 8;
  frame.depth_m[4] = 0.1F;
  frame.depth_m[5] = hole;
  EXPECT_EQ(clean_holes(frame, 0.3, 7.5), 5);
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(DepthFrame::is_hole(frame.depth_m[static_cast<std::size_t>(i)]));
  EXPECT_EQ(frame.depth_m[6], 2.0F);
}

}  // namespace
}  // namespace seamline::sensors
