#include "stimuli/pictures/distance_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "support/arithmetic/random.h"

namespace seamline {
namespace {

PixelSet set_of(int width_px, int height_px, const std::function<bool(int x, int y)>& inside) {
  PixelSet set{.width_px = width_px, .height_px = height_px, .values = {}};
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) set.values.push_back(inside(x, y) ? 1 : 0);
  return set;
}

/// By the definition: every pixel left out is looked at, and a frame of them around the picture.
std::vector<std::int64_t> distances_by_search(const PixelSet& set) {
  std::vector<std::int64_t> squares;
  for (int y = 0; y < set.height_px; ++y)
    for (int x = 0; x < set.width_px; ++x) {
      std::int64_t least = std::numeric_limits<std::int64_t>::max();
      for (int v = -1; v <= set.height_px; ++v)
        for (int u = -1; u <= set.width_px; ++u) {
          const bool outside = u < 0 || v < 0 || u == set.width_px || v == set.height_px;
          if (outside || set.values[static_cast<std::size_t>(v * set.width_px + u)] == 0)
            least = std::min<std::int64_t>(least, (u - x) * (u - x) + (v - y) * (v - y));
        }
      squares.push_back(least);
    }
  return squares;
}

TEST(DistanceTransform, IsTheNearestPixelLeftOut) {
  Random random(5);
  for (const double share : {0.05, 0.5, 0.9, 0.99, 1.0}) {
    const PixelSet set = set_of(37, 23, [&](int, int) { return random.uniform() < share; });
    EXPECT_EQ(squared_distances(set), distances_by_search(set)) << share;
  }
  EXPECT_EQ(squared_distances(set_of(1, 1, [](int, int) { return true; })), std::vector<std::int64_t>{1});
}

TEST(WidestBand, OfABandAlongAnAxisIsItsWidth) {
  for (const int wide : {1, 2, 5, 8}) {
    EXPECT_EQ(widest_band_px(set_of(60, 40, [&](int x, int) { return x >= 20 && x < 20 + wide; })), wide);
    EXPECT_EQ(widest_band_px(set_of(60, 40, [&](int, int y) { return y >= 9 && y < 9 + wide; })), wide);
    EXPECT_EQ(widest_band_px(set_of(60, 40, [&](int x, int) { return x < wide; })), wide) << "at the border";
  }
  EXPECT_EQ(widest_band_px(set_of(60, 40, [](int x, int) { return x == 3 || (x > 30 && x < 35); })), 4);
  // A frame that touches the border all round is wider in its corners: 5 * 2 sqrt 2 / (1 + sqrt 2) = 5.9; by
  // half pixels min(6, 5 sqrt 2).
  EXPECT_EQ(widest_band_px(set_of(60, 40, [](int x, int y) { return x < 5 || y < 5 || x >= 55 || y >= 35; })),
            6);
  EXPECT_EQ(widest_band_px(set_of(60, 40, [](int, int) { return true; })), 40);
}

TEST(WidestBand, OfNothingIsZeroAndOfAPixelOne) {
  EXPECT_EQ(widest_band_px(set_of(9, 7, [](int, int) { return false; })), 0);
  EXPECT_EQ(widest_band_px(set_of(9, 7, [](int x, int y) { return x == 4 && y == 2; })), 1);
  EXPECT_EQ(widest_band_px({}), 0);
}

TEST(WidestBand, OfABandAcrossAxesIsItsWidthToAPixel) {
  for (const double degrees : {10.0, 30.0, 45.0, 63.0})
    for (const double wide : {3.0, 6.0, 15.0}) {
      const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
      const PixelSet set = set_of(
          120, 120, [&](int x, int y) { return std::abs((x - 59.5) * c + (y - 59.5) * s) < wide / 2; });
      EXPECT_NEAR(widest_band_px(set), wide, 1.0) << degrees;
    }
  // By hand: pixels with |x - y| <= 1. From the half pixels of the diagonal to the nearest one of |x - y| = 2
  // it is a knight's move.
  EXPECT_EQ(widest_band_px(set_of(40, 40, [](int x, int y) { return std::abs(x - y) <= 1; })),
            std::sqrt(5.0));
}

TEST(WidestBand, OfADiscIsItsDiameterToAPixelAndAHalf) {
  for (const double radius : {1.5, 4.0, 10.5, 20.0}) {
    const PixelSet set =
        set_of(64, 50, [&](int x, int y) { return std::hypot(x - 30.0, y - 25.0) < radius; });
    EXPECT_NEAR(widest_band_px(set), 2 * radius, 1.5) << radius;
  }
}

}  // namespace
}  // namespace seamline
