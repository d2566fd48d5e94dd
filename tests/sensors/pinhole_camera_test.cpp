// A camera's rays and its picture are each other's inverse, with skew and every term of the lens.
#include "sensors/camera/pinhole_camera.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/arithmetic/random.h"
#include "support/text/error.h"

namespace seamline::sensors {
namespace {

PinholeCamera crooked_camera() {
  PinholeCamera camera{.width_px = 640,
                       .height_px = 480,
                       .fx_px = 518,
                       .fy_px = 519,
                       .cx_px = 325.5,
                       .cy_px = 253.5,
                       .skew_px = 1.7,
                       .distortion = {}};
  camera.distortion = {.k1 = -0.28, .k2 = 0.09, .p1 = 0.0012, .p2 = -0.0007, .k3 = -0.011};
  return camera;
}

TEST(PinholeCamera, BackProjectingAndProjectingIsTheIdentity) {
  const PinholeCamera camera = crooked_camera();
  Random random(7);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector2d at(camera.width_px * random.uniform(), camera.height_px * random.uniform());
    const auto direction = direction_through(camera, at);
    ASSERT_TRUE(direction) << at.transpose();
    const auto back = project(camera, *direction * (0.1 + 20 * random.uniform()));
    ASSERT_TRUE(back);
    worst = std::max(worst, (*back - at).norm());
  }
  EXPECT_LE(worst, 1e-6);
}

TEST(PinholeCamera, AgreesWithALensComputedByHand) {
  PinholeCamera camera{.width_px = 100,
                       .height_px = 100,
                       .fx_px = 100,
                       .fy_px = 200,
                       .cx_px = 50,
                       .cy_px = 40,
                       .skew_px = 3,
                       .distortion = {}};
  camera.distortion = {.k1 = 0.1, .k2 = 0.01, .p1 = 0.002, .p2 = 0.003, .k3 = 0.001};
  // x = 0.5, y = 0.25: r2 = 0.3125; radial = 1 + 0.03125 + 0.0009765625 + 0.000030517578125
  const double radial = 1.032257080078125;
  const double x = 0.5 * radial + 2 * 0.002 * 0.125 + 0.003 * (0.3125 + 0.5);
  const double y = 0.25 * radial + 0.002 * (0.3125 + 0.125) + 2 * 0.003 * 0.125;
  const auto found = project(camera, {1, 0.5, 2});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x(), 100 * x + 3 * y + 50, 1e-12);
  EXPECT_NEAR(found->y(), 200 * y + 40, 1e-12);
}

TEST(PinholeCamera, FieldOfViewIsTheOneAskedFor) {
  for (const double degrees : {1.0, 30.0, 57.8, 120.0, 170.0})
    EXPECT_NEAR(horizontal_field_of_view_deg(pinhole_of_field_of_view(160, 120, degrees)), degrees, 1e-9);
}

TEST(PinholeCamera, NothingBehindTheCameraOrBeyondTheFoldOfItsLens) {
  PinholeCamera camera = pinhole_of_field_of_view(640, 480, 90);
  EXPECT_FALSE(project(camera, {0, 0, -1}));
  EXPECT_FALSE(project(camera, {0, 0, 0}));
  camera.distortion.k1 = -0.5;  // x (1 - x^2 / 2) turns back at x = sqrt(2 / 3) = 0.816
  EXPECT_TRUE(project(camera, {0.8, 0, 1}));
  EXPECT_FALSE(project(camera, {0.85, 0, 1}));
  EXPECT_FALSE(project(camera, {1.35, 0, 1}));            // lands in the picture all the same
  EXPECT_FALSE(direction_through(camera, {639.9, 240}));  // x' = 1: beyond the largest, 0.544
}

TEST(PinholeCamera, ImpossibleCamerasAreRefusedByField) {
  PinholeCamera camera = crooked_camera();
  camera.fx_px = 0;
  try {
    require_valid(camera, "rig.toml: depth.");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "rig.toml: depth.fx: wanted a focal length above 0 pixels, found 0");
  }
  camera = crooked_camera();
  camera.distortion.k3 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(require_valid(camera, ""), InputError);
  camera = crooked_camera();
  camera.height_px = 1;
  EXPECT_THROW(require_valid(camera, ""), InputError);
}

}  // namespace
}  // namespace seamline::sensors
