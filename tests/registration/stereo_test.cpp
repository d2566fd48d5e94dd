// Matching finds the disparity that geometry says, of planes that were painted without the renderer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "registration/calibration/opencv.h"
#include "registration/stereo/semi_global.h"
#include "tests/complaint.h"

namespace seamline::registration {
namespace {

constexpr int width_px = 320, height_px = 200;
constexpr double fx_px = 300, baseline_m = 0.1;

/// A plane before the left camera: z = at_m + slope x, at x and y of its frame.
struct PaintedPlane {
  double at_m = 2, slope = 0;

  /// Of the ray (u, v, 1) from a camera so far to the right.
  [[nodiscard]] double z_m(double u, double aside_m) const {
    return (at_m + slope * aside_m) / (1 - slope * u);
  }
};

/// Smooth at the size of a pixel, without a period that a match could slip by.
double paint(double x_m, double y_m) {
  double value = 0;
  for (const double f : {31.0, 57.3, 83.9, 121.7})
    value += std::sin(f * x_m + 1.7 * std::sin(0.31 * f * y_m)) * std::cos(0.83 * f * y_m + f);
  return 0.5 + 0.12 * value;
}

ByteImage picture_of(const PaintedPlane& plane, double aside_m) {
  ByteImage picture{.width_px = width_px, .height_px = height_px, .channels = 3, .values = {}};
  constexpr int across = 3;  // samples of a pixel
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      double sum = 0;
      for (int j = 0; j < across; ++j)
        for (int i = 0; i < across; ++i) {
          const double u = (x + (i + 0.5) / across - width_px / 2.0) / fx_px,
                       v = (y + (j + 0.5) / across - height_px / 2.0) / fx_px;
          const double z_m = plane.z_m(u, aside_m);
          sum += paint(aside_m + u * z_m, v * z_m);
        }
      const auto code = static_cast<std::uint8_t>(std::lround(255 * std::clamp(sum / 9, 0.0, 1.0)));
      picture.values.insert(picture.values.end(), 3, code);
    }
  return picture;
}

/// Of the pixels that matching answers: how many, and the share within a quarter of a pixel of the truth.
struct Found {
  double answered = 0, within_quarter = 0, mean_error_px = 0;
};

Found find(const PaintedPlane& plane) {
  const std::vector<float> disparity_px = match_stereo(picture_of(plane, 0), picture_of(plane, baseline_m),
                                                       {.disparities_px = 48, .block_px = 5});
  Found found;
  int asked = 0, answered = 0, near = 0;
  for (int y = 0; y < height_px; ++y)
    for (int x = 40; x < width_px; ++x) {  // further left the right camera sees nothing of it
      ++asked;
      const float value = disparity_px[static_cast<std::size_t>(y * width_px + x)];
      if (!std::isfinite(value)) continue;
      ++answered;
      const double truth = fx_px * baseline_m / plane.z_m((x + 0.5 - width_px / 2.0) / fx_px, 0);
      const double error = static_cast<double>(value) - truth;
      found.mean_error_px += error;
      near += std::abs(error) <= 0.25 ? 1 : 0;
    }
  found.answered = static_cast<double>(answered) / asked;
  found.within_quarter = static_cast<double>(near) / answered;
  found.mean_error_px /= answered;
  return found;
}

TEST(Stereo, FindsThePlaneThatGeometrySays) {
  if (!has_opencv()) {
    EXPECT_NE(::seamline::test::complaint_of([] { (void)find({}); }).find("OpenCV"), std::string::npos);
    return;
  }
  for (const PaintedPlane& plane :
       {PaintedPlane{.at_m = 2}, PaintedPlane{.at_m = 1.37}, PaintedPlane{.at_m = 2, .slope = 0.6},
        PaintedPlane{.at_m = 1.5, .slope = -0.8}}) {
    const Found found = find(plane);
    EXPECT_GT(found.answered, 0.9) << plane.at_m << " " << plane.slope;
    EXPECT_GT(found.within_quarter, 0.98) << plane.at_m << " " << plane.slope;
    EXPECT_NEAR(found.mean_error_px, 0, 0.125) << plane.at_m << " " << plane.slope;  // drawn to whole ones
  }
}

TEST(Stereo, FindsNothingInGrey) {
  if (!has_opencv()) {
    EXPECT_FALSE(has_opencv());
    return;
  }
  ByteImage grey{.width_px = 64, .height_px = 48, .channels = 3, .values = {}};
  grey.values.assign(std::size_t{64} * 48 * 3, 128);
  const std::vector<float> found = match_stereo(grey, grey, {.disparities_px = 16, .block_px = 5});
  EXPECT_EQ(found.size(), std::size_t{64} * 48);
  EXPECT_TRUE(std::none_of(found.begin(), found.end(), [](float value) { return value > 0; }));
}

}  // namespace
}  // namespace seamline::registration
