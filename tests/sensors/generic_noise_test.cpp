// The generic model: relative noise, steps, dropouts and outliers of the size that was asked for.
#include "sensors/noise/generic_noise.h"

#include "tests/sensors/noise_samples.h"

namespace seamline::sensors {
namespace {

using namespace testing;

TEST(GenericNoise, IsNormalWithASigmaRelativeToTheDepth) {
  GenericNoise model;
  model.relative_sigma = 0.01;
  for (const double distance_m : {0.01, 3.0, 1e4})
    expect_normal(depths_of(measure_many(model, head_on(distance_m), 0.5)), distance_m, 0.005 * distance_m);
}

TEST(GenericNoise, StepsAreWholeMultiplesAndAddATwelfthOfTheirSquare) {
  GenericNoise model;
  model.relative_sigma = 0.01;
  model.step_m = 0.03;
  const auto depths_m = depths_of(measure_many(model, head_on(3)));
  for (const double depth_m : depths_m) ASSERT_NEAR(depth_m / 0.03, std::round(depth_m / 0.03), 1e-5);
  const double sigma_m = std::sqrt(0.03 * 0.03 + 0.03 * 0.03 / 12);
  EXPECT_NEAR(moments(depths_m).sigma, sigma_m, 4 * sigma_m / std::sqrt(2.0 * million));
  EXPECT_NEAR(moments(depths_m).mean, 3, 4 * sigma_m / 1000);
}

TEST(GenericNoise, DropoutsAndOutliersHaveTheirShares) {
  GenericNoise model;
  model.dropout_share = 0.2;
  model.outliers = {.share = 0.1, .nearest_m = 1, .farthest_m = 9};
  const auto pixels = measure_many(model, head_on(3));
  EXPECT_NEAR(share_of(pixels, PixelState::dropped), 0.2, four_sigma_of_share(0.2, million));
  EXPECT_NEAR(share_of(pixels, PixelState::outlier), 0.08, four_sigma_of_share(0.08, million));
  const auto uniform = [](double x) { return (x - 1) / 8; };
  EXPECT_LT(kolmogorov_ratio(depths_of(pixels, PixelState::outlier), uniform), 1);
  for (const double depth_m : depths_of(pixels)) ASSERT_EQ(depth_m, 3);
}

TEST(GenericNoise, SharesEndAtOne) {
  GenericNoise model;
  model.dropout_share = 0.2;
  EXPECT_EQ(share_of(measure_many(model, head_on(3), 5, 10000), PixelState::dropped), 1);
}

}  // namespace
}  // namespace seamline::sensors
