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

TEST(DepthTest, PlanesInTheWrongOrderAndOddBitsAreRefused) {
  for (const DepthBuffer& wrong :
       {DepthBuffer{0, 10, 24}, DepthBuffer{5, 5, 24}, DepthBuffer{1, 10, 7}, DepthBuffer{1, 10, 33}})
    EXPECT_THROW(require_valid(wrong, "buffer"), InputError);
  EXPECT_NO_THROW(require_valid(DepthBuffer{}, "buffer"));
}

}  // namespace
}  // namespace seamline::sensors
