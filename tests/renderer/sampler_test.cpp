#include "raytracer/common/sampler.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "raytracer/light/light.h"

namespace seamline::renderer {
namespace {

TEST(Sampler, SecondSobolDimensionIsTheSequencesOwn) {
  for (std::uint32_t index = 0; index < 5000; ++index) {
    std::uint32_t expected = 0;
    std::uint32_t direction = 1U << 31;
    for (std::uint32_t i = index; i != 0; i >>= 1, direction ^= direction >> 1)
      if (i & 1U) expected ^= direction;
    ASSERT_EQ(sobol_second_dimension(index), expected) << index;
  }
}

TEST(Sampler, EveryDyadicCellOfAPowerOfTwoHoldsOnePointOfEachHalf) {
  for (int dimension = 0; dimension < 10; ++dimension)
    for (const auto& [columns, rows] :
         {std::array{8, 8}, std::array{64, 1}, std::array{1, 64}, std::array{16, 4}}) {
      std::set<int> cells;
      for (int sample = 0; sample < 64; ++sample) {
        const Eigen::Array2f p = Sampler(42, 3, 7, 2 * sample + dimension % 2).point(dimension / 2);
        ASSERT_TRUE(p[0] >= 0 && p[0] < 1 && p[1] >= 0 && p[1] < 1);
        cells.insert(static_cast<int>(p[0] * static_cast<float>(columns)) * rows +
                     static_cast<int>(p[1] * static_cast<float>(rows)));
      }
      EXPECT_EQ(cells.size(), 64U);
    }
}

/// A pixel's half takes turns in order; who begins is left to chance, or two samples would never be enough.
TEST(Sampler, TurnsAreTakenFromADifferentBeginningInEveryHalf) {
  constexpr int of = 4, pixels = 4000;
  std::array<int, of> first{};
  int together = 0;
  for (int pixel = 0; pixel < pixels; ++pixel) {
    for (int half = 0; half < 2; ++half) {
      const int begin = Sampler(5, pixel, 1, half).turn(of);
      for (int i = 0; i < 2 * of; ++i)
        ASSERT_EQ(Sampler(5, pixel, 1, 2 * i + half).turn(of), (begin + i) % of);
      ++first[static_cast<std::size_t>(begin)];
    }
    if (Sampler(5, pixel, 1, 0).turn(of) == Sampler(5, pixel, 1, 1).turn(of)) ++together;
  }
  for (const int count : first) EXPECT_NEAR(count, 2 * pixels / of, 200);
  EXPECT_NEAR(together, pixels / of, 150);
}

/// What makes half the difference of two halves an honest estimate of the noise of their mean.
TEST(Sampler, TheTwoHalvesOfAPixelAreIndependent) {
  double variance_of_mean = 0, estimate = 0;
  const int pixels = 20000, samples = 8;
  for (int pixel = 0; pixel < pixels; ++pixel) {
    std::array<double, 2> mean{};
    for (int i = 0; i < samples; ++i) {
      const Eigen::Array2f p = Sampler(5, pixel, 1, i).point(0);
      mean[static_cast<std::size_t>(i % 2)] += (p[0] + p[1] < 0.7F ? 1.0 : 0.0) / (samples / 2);
    }
    const double error = 0.5 * (mean[0] + mean[1]) - 0.245;
    variance_of_mean += error * error / pixels;
    estimate += 0.25 * (mean[0] - mean[1]) * (mean[0] - mean[1]) / pixels;
  }
  EXPECT_NEAR(estimate / variance_of_mean, 1, 0.05);
}

TEST(Sampler, PixelsAndSeedsAreDecorrelated) {
  double correlation = 0;
  const int count = 20000;
  for (int i = 0; i < count; ++i)
    correlation += (Sampler(1, i, 0, 0).point(0)[0] - 0.5) * (Sampler(1, i + 1, 0, 0).point(0)[0] - 0.5) * 12;
  EXPECT_LT(std::abs(correlation / count), 4 / std::sqrt(count));
  EXPECT_NE(Sampler(1, 0, 0, 0).point(0)[0], Sampler(2, 0, 0, 0).point(0)[0]);
}

TEST(Sampler, CosineDirectionsAreUnitAndCosineWeighted) {
  const Eigen::Vector3f normal = Eigen::Vector3f(0.3F, -0.8F, 0.2F).normalized();
  double cosine = 0, square = 0;
  const int count = 1 << 14;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f d = cosine_weighted(normal, Sampler(1, 0, 0, i).point(0));
    ASSERT_NEAR(d.norm(), 1, 1e-5);
    cosine += d.dot(normal);
    square += d.dot(normal) * d.dot(normal);
  }
  EXPECT_NEAR(cosine / count, 2.0 / 3, 1e-3);
  EXPECT_NEAR(square / count, 0.5, 1e-3);
}

}  // namespace
}  // namespace seamline::renderer
