// The error of the change from one picture to the next.
#include "raytracer/error/change_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/arithmetic/random.h"

namespace seamline::renderer {
namespace {

constexpr int width = 160, height = 120;
constexpr float grey = 0.3F;
constexpr double curve_slope = 0.8906;  // of the sRGB curve there

/// A grey picture whose two halves have `noise` from one stream of numbers, and `more` from another.
HalfPictures noisy(float radiance, double noise, double more, std::uint64_t own_seed, int rows = height) {
  Random same(3), own(own_seed);
  HalfPictures pictures;
  pictures.whole = Image(width, rows, 3);
  for (Image& half : pictures.filtered) {
    half = Image(width, rows, 3);
    for (std::size_t i = 0; i < half.values.size(); ++i) {
      half.values[i] = radiance + static_cast<float>(noise * same.normal() + more * own.normal());
      pictures.whole.values[i] += 0.5F * half.values[i];
    }
  }
  pictures.sampled = pictures.filtered;
  return pictures;
}

ErrorMap map_of(const HalfPictures& pictures) {
  return error_map(pictures, {}, 0.0, 2);
}

TEST(ChangeError, APictureDoesNotChangeIntoItself) {
  const ErrorMap map = map_of(noisy(grey, 0.02, 0, 1));
  EXPECT_EQ(change_error(map, map), 0);
}

TEST(ChangeError, NoiseThatStandsStillIsNoErrorOfTheChange) {
  const ErrorMap before = map_of(noisy(grey, 0.02, 0, 1));
  const ErrorMap now = map_of(noisy(grey + 0.001F, 0.02, 0, 1));
  // What is left is rounding to 8 bits, and that the display curve is not straight.
  EXPECT_LT(std::sqrt(change_error(before, now)), 0.0018);
}

TEST(ChangeError, FindsNoiseThatIsNewInEachPicture) {
  for (const double more : {0.01, 0.03}) {
    const ErrorMap before = map_of(noisy(grey, 0.02, more, 1)), now = map_of(noisy(grey, 0.02, more, 2));
    // A mean of two halves has more / sqrt(2), and the change of two such means sqrt(2) times that.
    const double rounding = 2 * rounding_square;
    EXPECT_NEAR(std::sqrt(change_error(before, now) - rounding), curve_slope * more, 0.03 * more);
  }
}

TEST(ChangeError, FindsWhatAFilterChangesFromPictureToPicture) {
  HalfPictures before = noisy(grey, 0.02, 0, 1), now = before;
  for (Image& half : now.sampled)
    for (float& value : half.values) value += 0.01F;
  EXPECT_NEAR(std::sqrt(change_error(map_of(before), map_of(now))), curve_slope * 0.01, 3e-4);
  for (Image& half : before.sampled)
    for (float& value : half.values) value += 0.01F;
  EXPECT_EQ(change_error(map_of(before), map_of(now)), 0) << "the same bias in both does not flicker";
}

TEST(ChangeError, OfLargePicturesSomeRowsAreLookedAt) {
  const ErrorMap before = map_of(noisy(grey, 0, 0.02, 1, 1080)), now = map_of(noisy(grey, 0, 0.02, 2, 1080));
  EXPECT_EQ(now.rows.size(), 270U);
  EXPECT_EQ(now.rounded_by.size(), 270U * width * 3);
  EXPECT_NEAR(std::sqrt(change_error(before, now) - 2 * rounding_square), curve_slope * 0.02, 0.0006);
}

}  // namespace
}  // namespace seamline::renderer
