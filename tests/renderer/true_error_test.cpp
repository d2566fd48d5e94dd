// A planted error comes back whatever the reference's own noise.
#include "raytracer/error/true_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "raytracer/error/error_estimate.h"
#include "support/arithmetic/random.h"

namespace seamline::renderer {
namespace {

constexpr int width_px = 320, height_px = 160;

struct Planted {
  ByteImage shown;
  ReferenceHalves reference;
};

/// Codes 80 to 170; the reference differs from them by `error` (display units, checkered) and by noise of
/// its own in each half. Codes are exact: there is no rounding beside what is planted.
Planted plant(double error, double noise, std::uint64_t seed) {
  Random random(seed);
  Planted out{{width_px, height_px, 3, {}}, {Image(width_px, height_px, 3), Image(width_px, height_px, 3)}};
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x)
      for (int c = 0; c < 3; ++c) {
        const auto code = static_cast<std::uint8_t>(80 + (x + 2 * y + 7 * c) % 90);
        out.shown.values.push_back(code);
        const float linear = linear_from_srgb(static_cast<float>(code) / 255.0F);
        const double to_linear = 1 / double{display_slope(linear)};
        const double truth = linear + to_linear * ((x + y) % 2 == 0 ? error : -error);
        for (Image& half : out.reference)
          half.at(x, y, c) = static_cast<float>(truth + to_linear * noise * random.normal());
      }
  return out;
}

TEST(TrueError, APlantedErrorIsFoundUnderTenTimesAsMuchNoise) {
  int within = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Planted planted = plant(0.004, 0.04, seed);
    const TrueError found = true_error(planted.shown, planted.reference, 0);
    EXPECT_NEAR(found.rmse(), 0.004, 0.0015);
    within += std::abs(found.squared - 0.004 * 0.004) < 2 * found.squared_standard_error ? 1 : 0;
  }
  EXPECT_GE(within, 8);
}

TEST(TrueError, WithoutAnErrorNoneIsFound) {
  const Planted planted = plant(0, 0.04, 3);
  const TrueError found = true_error(planted.shown, planted.reference, 0);
  EXPECT_LT(std::abs(found.squared), 3 * found.squared_standard_error);
  EXPECT_LT(found.rmse(), 0.003);
}

TEST(TrueError, TheWorstTileIsWhereTheErrorIs) {
  Planted planted = plant(0.002, 0.002, 5);
  for (int y = 64; y < 96; ++y)
    for (int x = 32; x < 64; ++x)
      for (Image& half : planted.reference) half.at(x, y, 1) += 0.05F;
  const TrueError found = true_error(planted.shown, planted.reference, 0);
  EXPECT_EQ(found.worst_tile(), 2 * (width_px / 32) + 1);
  EXPECT_GT(found.worst_tile_rmse(), 5 * found.rmse() / 2);
}

TEST(TrueError, ExposureIsUndoneAndReferencesBeyondWhiteAreWhite) {
  Planted planted = plant(0.01, 0, 1);
  const double without = true_error(planted.shown, planted.reference, 0).squared;
  for (Image& half : planted.reference)
    for (float& value : half.values) value *= 0.5F;
  EXPECT_NEAR(true_error(planted.shown, planted.reference, 1).squared, without, 1e-9);
  std::fill(planted.shown.values.begin(), planted.shown.values.end(), std::uint8_t{255});
  for (Image& half : planted.reference) std::fill(half.values.begin(), half.values.end(), 3.0F);
  EXPECT_EQ(true_error(planted.shown, planted.reference, 1).squared, 0);
}

/// References that have a twentieth of their light from one sample in `one_in`, far beyond white where it is
/// rare: all others are too dark by that twentieth, and no picture is at fault.
TrueError error_of_rare_light(double one_in) {
  constexpr double share = 0.05;
  Planted planted = plant(0.004, 0, 1);
  Random random(101);
  for (Image& half : planted.reference)
    for (float& value : half.values)
      value *= static_cast<float>(1 - share + (random.uniform() * one_in < 1 ? share * one_in : 0));
  return true_error(planted.shown, planted.reference, 0);
}

TEST(TrueError, AReferenceOfRareLightSaysThatItIsNoisy) {
  const TrueError rare = error_of_rare_light(200);
  EXPECT_TRUE(rare.reference_is_noisy());
  EXPECT_GT(rare.rmse(), 2 * 0.004) << "the error is said with the reference's own";
  EXPECT_LT(rare.squared_with_rare_light, rare.squared);
  const TrueError often = error_of_rare_light(2);
  EXPECT_FALSE(often.reference_is_noisy());
  EXPECT_NEAR(often.rmse(), 0.004, 4 * often.standard_error());
}

/// An error is the difference of what is shown, however large: never more than 1, and as much of a black
/// picture that should be white as of a white one that should be black.
TEST(TrueError, ALargeErrorIsTheDifferenceOnTheDisplay) {
  for (const auto& [code, reference] :
       {std::pair{0, 0.02F}, {0, 1.0F}, {255, 0.0F}, {10, 0.5F}, {240, 0.1F}}) {
    const ByteImage shown{64, 32, 3, std::vector<std::uint8_t>(64 * 32 * 3, static_cast<std::uint8_t>(code))};
    const ReferenceHalves halves = {Image(64, 32, 3, reference), Image(64, 32, 3, reference)};
    EXPECT_NEAR(true_error(shown, halves, 0).rmse(),
                std::abs(code / 255.0 - double{srgb_from_linear(reference)}), 1e-5)
        << code << " for " << reference;
  }
}

TEST(TrueError, LinearErrorLooksThroughItsMaskOnly) {
  const ReferenceHalves reference = {Image(64, 64, 3, 0.5F), Image(64, 64, 3, 0.5F)};
  Image picture(64, 64, 3, 0.6F), mask(64, 64, 1);
  picture.set_rgb(3, 3, Rgb::Constant(9));
  mask.at(40, 50) = mask.at(41, 50) = 1;
  EXPECT_NEAR(true_linear_error(picture, reference, mask).rmse(), 0.1, 1e-6);
}

}  // namespace
}  // namespace seamline::renderer
