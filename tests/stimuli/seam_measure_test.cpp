#include "stimuli/pictures/seam_measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/arithmetic/random.h"

namespace seamline {
namespace {

constexpr int across_px = 200, down_px = 150;  // neither is a multiple of a tile

using StepsAt = std::function<double(int x, int y, int channel)>;

/// A grey picture to which steps were added.
ByteImage picture_of(const StepsAt& steps) {
  ByteImage image{across_px, down_px, 3, {}};
  for (int y = 0; y < down_px; ++y)
    for (int x = 0; x < across_px; ++x)
      for (int c = 0; c < 3; ++c)
        image.values.push_back(static_cast<std::uint8_t>(std::lround(120 + steps(x, y, c))));
  return image;
}

const ByteImage& grey() {
  static const ByteImage image = picture_of([](int, int, int) { return 0; });
  return image;
}

std::int64_t area(const SeamMeasure& measure, std::size_t step) {
  return measure.beyond[step].area_px;
}

double band(const SeamMeasure& measure, std::size_t step) {
  return measure.beyond[step].widest_band_px;
}

TEST(SeamMeasure, OfEqualPicturesIsNothing) {
  const SeamMeasure measure = measure_seam(grey(), grey());
  for (const SeamExtent& extent : measure.beyond) {
    EXPECT_EQ(extent.area_px, 0);
    EXPECT_EQ(extent.widest_band_px, 0);
  }
  EXPECT_EQ(measure.largest_noise_steps, 0);
}

TEST(SeamMeasure, OfABandIsItsAreaAndWidthAtTheStepsThatItExceeds) {
  for (const int width : {1, 2, 5})
    for (const int sign : {1, -1}) {
      // In one channel only, whose difference is the pixel's.
      const auto band_of = [&](int steps) {
        return measure_seam(picture_of([&](int x, int, int channel) {
                              return channel == 1 && x >= 61 && x < 61 + width ? sign * steps : 0;
                            }),
                            grey());
      };
      const SeamMeasure measure = band_of(5);
      for (const std::size_t step : {0U, 1U}) {
        EXPECT_EQ(area(measure, step), width * down_px);
        EXPECT_EQ(band(measure, step), width);
      }
      EXPECT_EQ(area(measure, 2), 0);
      EXPECT_EQ(area(band_of(4), 1), 0) << "four is not more than four";
      EXPECT_EQ(area(band_of(9), 2), width * down_px);
    }
}

TEST(SeamMeasure, OfADiscAndAFrame) {
  const SeamMeasure disc = measure_seam(
      picture_of([](int x, int y, int) { return std::hypot(x - 100.0, y - 70.0) < 20 ? 10 : 0; }), grey());
  EXPECT_NEAR(static_cast<double>(area(disc, 2)), M_PI * 400, 15);
  EXPECT_NEAR(band(disc, 2), 40, 1.5);
  const SeamMeasure frame =
      measure_seam(picture_of([](int x, int y, int) {
                     return x < 3 || y < 3 || x >= across_px - 3 || y >= down_px - 3 ? 10 : 0;
                   }),
                   grey());
  EXPECT_EQ(area(frame, 2), across_px * down_px - (across_px - 6) * (down_px - 6));
  EXPECT_EQ(band(frame, 2), 4);  // in the corners, see WidestBand
}

TEST(SeamMeasure, SinglePixelsAndNeighboursOfOtherSignDoNotCount) {
  const SeamMeasure single =
      measure_seam(picture_of([](int x, int y, int) { return x % 7 == 0 && y % 9 == 0 ? 50 : 0; }), grey());
  for (const SeamExtent& extent : single.beyond) EXPECT_EQ(extent.area_px, 0);
  const auto pair = [](double second) {
    return measure_seam(picture_of([&](int x, int y, int) {
                          if (x == 50 && y == 50) return 50.0;
                          return x == 51 && y == 51 ? second : 0.0;
                        }),
                        grey());
  };
  EXPECT_EQ(area(pair(50), 2), 2);
  EXPECT_EQ(area(pair(-50), 2), 0);
}

TEST(SeamNoise, IsFoundToAFewPerCent) {
  for (const double sigma : {0.7, 1.0, 3.0, 8.0}) {
    Random random(11);
    const ByteImage noisy =
        picture_of([&](int, int, int) { return std::clamp(sigma * random.normal(), -100.0, 100.0); });
    const NoiseTiles tiles = noise_tiles(signed_difference(noisy, grey()));
    ASSERT_EQ(tiles.columns, 6);
    ASSERT_EQ(tiles.rows, 5);
    double sum = 0;
    for (const double deviation : tiles.deviation_steps) sum += deviation;
    const double wanted = std::hypot(sigma, std::sqrt(1 / 12.0));  // with the rounding to whole steps
    EXPECT_NEAR(sum / static_cast<double>(tiles.deviation_steps.size()), wanted, 0.03 * wanted) << sigma;
    const SeamMeasure measure = measure_seam(noisy, grey());
    if (sigma < 8) {
      EXPECT_EQ(area(measure, 2), 0) << sigma;
    }
    EXPECT_LT(area(measure, 0), across_px * down_px / 1000) << sigma;
  }
}

TEST(SeamNoise, IsNotRaisedByWhatIsFlatSlopedOrAnEdge) {
  const NoiseTiles tiles = noise_tiles(signed_difference(
      picture_of([](int x, int y, int) {
        return (x > 90 ? 40 : 0) + (std::hypot(x - 40.0, y - 60.0) < 15 ? 30 : 0) + (y > 100 ? y - 100 : 0);
      }),
      grey()));
  for (const double deviation : tiles.deviation_steps) EXPECT_EQ(deviation, 0);
}

TEST(SeamMeasure, AStepOfSixOverNoiseOfOneCountsAtTwoAndFourNotAtEight) {
  Random random(3);
  const SeamMeasure measure = measure_seam(picture_of([&](int x, int y, int) {
                                             const bool inside = x >= 60 && x < 140 && y >= 40 && y < 110;
                                             return (inside ? 6 : 0) + random.normal();
                                           }),
                                           grey());
  constexpr std::int64_t whole = 80 * 70;
  EXPECT_GT(area(measure, 0), whole * 95 / 100);  // a pixel's largest channel exceeds 2 + 3 sigma
  EXPECT_LT(area(measure, 0), whole * 102 / 100);
  EXPECT_GT(area(measure, 1), whole * 20 / 100);  // and not always 4 + 3 sigma
  EXPECT_EQ(area(measure, 2), 0);
}

}  // namespace
}  // namespace seamline
