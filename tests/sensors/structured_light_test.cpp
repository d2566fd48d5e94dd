// Structured light: noise and steps are even in disparity, so both grow with the square of the distance.
#include "sensors/noise/structured_light.h"

#include <map>

#include "tests/sensors/noise_samples.h"

namespace seamline::sensors {
namespace {

using namespace testing;

TEST(StructuredLight, DisparityHasNormalNoiseOfItsSigma) {
  StructuredLightNoise model;
  model.step_px = 0;
  const double product = model.focal_px * model.baseline_m;
  for (const double distance_m : {0.8, 4.0}) {
    std::vector<double> disparities_px;
    for (const double depth_m : depths_of(measure_many(model, head_on(distance_m))))
      disparities_px.push_back(product / depth_m);
    expect_normal(disparities_px, product / distance_m, model.sigma_px);
  }
}

TEST(StructuredLight, SigmaOfTheDepthGrowsWithTheSquareOfTheDistance) {
  StructuredLightNoise model;
  for (const double distance_m : {0.8, 1.6, 3.2}) {
    const auto depths_m = depths_of(measure_many(model, head_on(distance_m)));
    const double by_noise = distance_m * distance_m / (model.focal_px * model.baseline_m) * model.sigma_px;
    EXPECT_NEAR(noise_sigma_m(model, head_on(distance_m), 1), by_noise, 1e-12);
    // Rounded to steps of twice sigma: variance 1 + (2^2 / 12) of the noise's, but for Sheppard's ripple,
    // whose size hangs on where between two steps the distance lies (below 3 % at this ratio).
    EXPECT_NEAR(moments(depths_m).sigma, by_noise * std::sqrt(1 + 4.0 / 12), 0.03 * by_noise);
  }
}

TEST(StructuredLight, DepthsAreThoseOfWholeStepsInTheSharesOfARoundedNormal) {
  StructuredLightNoise model;
  const double distance_m = 2.3, product = model.focal_px * model.baseline_m;
  const double place = product / distance_m / model.step_px, sigma = model.sigma_px / model.step_px;
  std::map<long, double> found;
  for (const double depth_m : depths_of(measure_many(model, head_on(distance_m)))) {
    const double steps = product / depth_m / model.step_px;
    ASSERT_NEAR(steps, std::round(steps), 1e-4);
    found[std::lround(steps)] += 1;
  }
  std::vector<double> counts, expected;
  double rest = million, rest_expected = million;
  for (long step = std::lround(place) - 1; step <= std::lround(place) + 1; ++step) {
    const double p = normal_cdf((static_cast<double>(step) + 0.5 - place) / sigma) -
                     normal_cdf((static_cast<double>(step) - 0.5 - place) / sigma);
    counts.push_back(found[step]);
    expected.push_back(p * million);
    rest -= counts.back();
    rest_expected -= expected.back();
  }
  counts.push_back(rest);
  expected.push_back(rest_expected);
  EXPECT_LT(chi_squared_ratio(counts, expected), 1);
}

TEST(StructuredLight, GrazingNoiseIsTheTermOfNguyensFit) {
  StructuredLightNoise model;
  model.step_px = 0;
  model.grazing_sigma_m = 0.0001;
  model.sure_deg = 90;
  const double angle = 70 * std::numbers::pi / 180, distance_m = 2;
  const double rest = std::numbers::pi / 2 - angle;
  const double of_angle = 0.0001 / std::sqrt(distance_m) * angle * angle / (rest * rest);
  const double of_noise = distance_m * distance_m / (model.focal_px * model.baseline_m) * model.sigma_px;
  const double sigma_m = std::sqrt(of_angle * of_angle + of_noise * of_noise);
  const SeenPixel seen = head_on(distance_m, 0.5, std::cos(angle));
  EXPECT_NEAR(noise_sigma_m(model, seen, 1), sigma_m, 1e-9);
  EXPECT_NEAR(moments(depths_of(measure_many(model, seen))).sigma, sigma_m, 0.005 * sigma_m);
}

TEST(StructuredLight, DropoutsRiseWithAngleAndDarkness) {
  StructuredLightNoise model;
  model.sure_deg = 60;
  model.lost_deg = 80;
  model.sure_signal = 0.2;
  model.lost_signal = 0.1;
  const auto dropped = [&](double degrees, double albedo, double scale = 1) {
    const double cosine = std::cos(degrees * std::numbers::pi / 180);
    return share_of(measure_many(model, head_on(1, albedo, cosine), scale, 100000), PixelState::dropped);
  };
  const double four_sigma = four_sigma_of_share(0.5, 100000);
  EXPECT_EQ(dropped(0, 0.5), 0);
  EXPECT_NEAR(dropped(70, 1), 0.5, four_sigma);    // half way; signal 0.34 is enough
  EXPECT_NEAR(dropped(0, 0.15), 0.5, four_sigma);  // half way in darkness
  EXPECT_NEAR(dropped(0, 0.15, 0.5), 0.25, four_sigma);
  EXPECT_EQ(dropped(0, 0.05), 1);
  EXPECT_EQ(dropped(85, 1), 1);
}

TEST(StructuredLight, TheProjectorsShadowIsAHoleAtAnyScale) {
  SeenPixel seen = head_on(1);
  seen.lit_by_projector = false;
  for (const double scale : {1e-6, 1.0, 100.0})
    EXPECT_EQ(share_of(measure_many(StructuredLightNoise{}, seen, scale, 1000), PixelState::shadowed), 1);
}

}  // namespace
}  // namespace seamline::sensors
