// The fisheye of Kannala and Brandt: directions to pixels and back, and where its law says they lie.
#include "sensors/camera/fisheye_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sensors/camera/pinhole_camera.h"
#include "support/arithmetic/random.h"

namespace seamline::sensors {
namespace {

constexpr double fisheye_pi = std::numbers::pi;

FisheyeCamera test_lens() {
  return {.width_px = 816,
          .height_px = 960,
          .fx_px = 497.8,
          .fy_px = 496.2,
          .cx_px = 396.5,
          .cy_px = 463.4,
          .skew_px = 0.4,
          .k1 = -0.029,
          .k2 = 0.021,
          .k3 = -0.032,
          .k4 = 0.0166};
}

TEST(FisheyeCameras, DirectionsComeBack) {
  const FisheyeCamera lens = test_lens();
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const double theta = 1.4 * random.uniform(), azimuth = 2 * fisheye_pi * random.uniform();
    const Eigen::Vector3d direction(std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth),
                                    std::cos(theta));
    const auto place_px = project(lens, 3.7 * direction);
    ASSERT_TRUE(place_px);
    const auto again = direction_through(lens, *place_px);
    ASSERT_TRUE(again);
    EXPECT_LT((*again - direction).norm(), 1e-12);
  }
}

TEST(FisheyeCameras, AnglesAreWhatTheLawSays) {
  // Without terms the distance from the middle is the angle, also behind the camera.
  const FisheyeCamera even{.fx_px = 100, .fy_px = 100, .cx_px = 320, .cy_px = 240};
  for (const double theta : {0.0, 0.3, 1.0, fisheye_pi / 2, 2.5}) {
    const auto place_px = project(even, {std::sin(theta), 0, std::cos(theta)});
    ASSERT_TRUE(place_px);
    EXPECT_NEAR(place_px->x(), 320 + 100 * theta, 1e-9);
    EXPECT_NEAR(place_px->y(), 240, 1e-9);
  }
  const auto behind = direction_through(even, {320, 240 + 100 * 2.5});
  ASSERT_TRUE(behind);
  EXPECT_NEAR(behind->z(), std::cos(2.5), 1e-12);
  EXPECT_FALSE(direction_through(even, {320 + 100 * 3.2, 240}));  // beyond 180 degrees
  const FisheyeCamera lens = test_lens();
  const double t = 0.8, bent = t * (1 + lens.k1 * std::pow(t, 2) + lens.k2 * std::pow(t, 4) +
                                    lens.k3 * std::pow(t, 6) + lens.k4 * std::pow(t, 8));
  EXPECT_NEAR(project(lens, {std::sin(t), 0, std::cos(t)})->x(), lens.cx_px + lens.fx_px * bent, 1e-9);
}

TEST(FisheyeCameras, NearTheAxisItIsAPinhole) {
  const FisheyeCamera lens = test_lens();
  PinholeCamera pinhole;
  pinhole.fx_px = lens.fx_px, pinhole.fy_px = lens.fy_px, pinhole.cx_px = lens.cx_px;
  pinhole.cy_px = lens.cy_px, pinhole.skew_px = lens.skew_px;
  const Eigen::Vector3d point(1e-4, -2e-4, 1);
  EXPECT_LT((*project(lens, point) - *project(pinhole, point)).norm(), 1e-7);
}

TEST(FisheyeCameras, BeyondAFoldThereIsNothing) {
  const FisheyeCamera folded{.fx_px = 100, .fy_px = 100, .cx_px = 320, .cy_px = 240, .k1 = -0.5};
  // theta - theta^3 / 2 turns back at theta = sqrt(2 / 3) = 0.816.
  EXPECT_TRUE(project(folded, {std::sin(0.8), 0, std::cos(0.8)}));
  EXPECT_FALSE(project(folded, {std::sin(0.9), 0, std::cos(0.9)}));
  EXPECT_FALSE(direction_through(folded, {320 + 60, 240}));
}

}  // namespace
}  // namespace seamline::sensors
