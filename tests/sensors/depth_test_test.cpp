#include "sensors/frame/depth_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/text/error.h"

namespace seamline::sensors {
namespace {

DepthFrame two_by_two(std::vector<float> depth_m) {
  DepthFrame frame;
  frame.camera.width_px = frame.camera.height_px = 2;
  frame.depth_m = std::move(depth_m);
  return frame;
}

TEST(DepthTest, ThePixelsOwnDepthDecidesAndHolesHideNothing) {
  const DepthFrame frame = two_by_two({1, 2, 3, hole});
  EXPECT_TRUE(hides_in_metres(frame, 0.9, 0.9, 1.001));
  EXPECT_FALSE(hides_in_metres(frame, 0.9, 0.9, 0.999));
  EXPECT_FALSE(hides_in_metres(frame, 0.9, 0.9, 1));  // of equal depths the virtual one is seen
  EXPECT_FALSE(hides_in_metres(frame, 1.1, 0.9, 1.5));
  EXPECT_FALSE(hides_in_metres(frame, 1.5, 1.5, 1e9));
  EXPECT_FALSE(hides_in_buffer(frame, 1.5, 1.5, 1e9, {}));
  EXPECT_TRUE(hides_in_metres(frame, -7, -7, 1.5));  // outside: the pixel at the edge
}

TEST(DepthTest, ABufferHasItsPlanesAtItsEndsAndRisesBetween) {
  const DepthBuffer buffer{.nearest_m = 0.5, .farthest_m = 50, .bits = 16};
  EXPECT_EQ(depth_buffer_step(buffer, 0.5), 0);
  EXPECT_EQ(depth_buffer_step(buffer, 0.1), 0);
  EXPECT_EQ(depth_buffer_step(buffer, 50), 65535);
  EXPECT_EQ(depth_buffer_step(buffer, 1e9), 65535);
  std::int64_t before = 0;
  for (double planar_m = 0.5; planar_m < 50; planar_m *= 1.01) {
    EXPECT_GE(depth_buffer_step(buffer, planar_m), before);
    before = depth_buffer_step(buffer, planar_m);
  }
}

/// Two surfaces as far apart as several steps are told apart, by a tenth of a step they are not: the error of
/// a buffer grows with the square of the distance.
TEST(DepthTest, ABuffersErrorIsItsStep) {
  const DepthBuffer buffer{.nearest_m = 0.1, .farthest_m = 100, .bits = 16};
  for (const float real_m : {0.5F, 2.0F, 8.0F, 30.0F}) {
    const DepthFrame frame = two_by_two({real_m, real_m, real_m, real_m});
    const double step_m = depth_buffer_step_m(buffer, static_cast<double>(real_m));
    EXPECT_TRUE(hides_in_buffer(frame, 1, 1, static_cast<double>(real_m) + 1.6 * step_m, buffer));
    EXPECT_FALSE(hides_in_buffer(frame, 1, 1, static_cast<double>(real_m) - 0.1 * step_m, buffer));
    EXPECT_TRUE(hides_in_metres(frame, 1, 1, static_cast<double>(real_m) + 0.1 * step_m));
  }
  EXPECT_NEAR(depth_buffer_step_m(buffer, 8) / depth_buffer_step_m(buffer, 2), 16, 1e-9);
}

/// Between the centres of pixels a plane's planar depth that is linear in the picture is itself; beyond them
/// the outermost pixels count.
TEST(DepthTest, BetweenPixelsDepthIsLinear) {
  DepthFrame frame;
  frame.camera.width_px = 5, frame.camera.height_px = 4;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 5; ++column)
      frame.depth_m.push_back(static_cast<float>(2 + 0.5 * column - 0.25 * row));
  for (double y = 0.5; y <= 3.5; y += 0.125)
    for (double x = 0.5; x <= 4.5; x += 0.125)
      EXPECT_FLOAT_EQ(depth_between(frame, x, y), static_cast<float>(2 + 0.5 * (x - 0.5) - 0.25 * (y - 0.5)));
  EXPECT_EQ(depth_between(frame, 0.1, 0.2), 2);
  EXPECT_EQ(depth_between(frame, 5, 4), frame.at(4, 3));
}

TEST(DepthTest, AHoleIsItsPixelsAndHasNoPartInItsNeighbours) {
  const DepthFrame frame = two_by_two({1, 3, hole, 3});
  EXPECT_FLOAT_EQ(depth_between(frame, 1, 0.5), 2);
  EXPECT_EQ(depth_between(frame, 0.6, 1.4), hole);
  EXPECT_FLOAT_EQ(depth_between(frame, 1.2, 1.4), 3 - 2 * 0.3F * 0.1F / (1 - 0.3F * 0.9F));
  EXPECT_EQ(depth_between(two_by_two({hole, hole, hole, hole}), 1, 1), hole);
}

TEST(DepthTest, TheNearerInMetresOrInStepsHides) {
  const DepthBuffer coarse{.nearest_m = 0.1, .farthest_m = 100, .bits = 16};
  EXPECT_TRUE(hides(8, 8.001, nullptr));
  EXPECT_FALSE(hides(8, 8, nullptr));
  EXPECT_FALSE(hides(8, 8 + 0.4 * depth_buffer_step_m(coarse, 8), &coarse) &&
               hides(8, 8 - 0.4 * depth_buffer_step_m(coarse, 8), &coarse));
  EXPECT_TRUE(hides(8, 8 + 1.1 * depth_buffer_step_m(coarse, 8), &coarse));
  for (const DepthBuffer* buffer : {static_cast<const DepthBuffer*>(nullptr), &coarse})
    EXPECT_FALSE(hides(static_cast<double>(hole), 1e9, buffer));
}

TEST(DepthTest, PlanesInTheWrongOrderAndOddBitsAreRefused) {
  for (const DepthBuffer& wrong :
       {DepthBuffer{0, 10, 24}, DepthBuffer{5, 5, 24}, DepthBuffer{1, 10, 7}, DepthBuffer{1, 10, 33}})
    EXPECT_THROW(require_valid(wrong, "buffer"), InputError);
  EXPECT_NO_THROW(require_valid(DepthBuffer{}, "buffer"));
}

}  // namespace
}  // namespace seamline::sensors
