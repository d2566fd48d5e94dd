#include "analysis/statistics/isotonic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/arithmetic/random.h"

namespace seamline::analysis {
namespace {

/// min over begin <= i of max over end > i of the mean of [begin, end): the non-increasing fit by its min-max
/// formula.
double min_max(const std::vector<double>& values, std::size_t i) {
  double least = above_every_level;
  for (std::size_t begin = 0; begin <= i; ++begin) {
    double greatest = below_every_level;
    for (std::size_t end = i + 1; end <= values.size(); ++end) {
      const double sum = std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                         values.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
      greatest = std::max(greatest, sum / static_cast<double>(end - begin));
    }
    least = std::min(least, greatest);
  }
  return least;
}

TEST(Isotonic, EqualsTheMinMaxFormulaOnRandomData) {
  Random random(1);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<double> values(1 + random.below(9));
    for (double& value : values) value = static_cast<double>(random.below(5));  // ties on purpose
    const IsotonicFit fit = fit_non_increasing(values);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(fit.value[i], min_max(values, i), 1e-12);
    EXPECT_TRUE(std::is_sorted(fit.value.rbegin(), fit.value.rend()));
  }
}

TEST(Isotonic, BlocksHoldWhatWasPooled) {
  const IsotonicFit fit = fit_non_increasing(std::vector<double>{4, 1, 2, 0});
  EXPECT_EQ(fit.value, (std::vector<double>{4, 1.5, 1.5, 0}));
  EXPECT_EQ(fit.block_begin, (std::vector<std::size_t>{0, 1, 1, 3}));
  EXPECT_EQ(fit.block_end, (std::vector<std::size_t>{1, 3, 3, 4}));
}

const std::vector<double> four_octaves = {6, 7, 8, 9};

double at_half(const std::vector<double>& fit) {
  return largest_x_at(0.5, four_octaves, fit);
}

TEST(Threshold, CrossesBetweenTwoWidthsLinearlyInLog2) {
  EXPECT_DOUBLE_EQ(at_half({4, 1, 0.25, 0}), 7 + 2.0 / 3);
}

TEST(Threshold, NeverCrossing) {
  EXPECT_EQ(at_half({4, 3, 2, 0.6}), above_every_level);
  EXPECT_EQ(at_half({0.4, 0.3, 0.3, 0}), below_every_level);
}

TEST(Threshold, TakesTheRightEndOfAFlatPartAtTheLevel) {
  EXPECT_DOUBLE_EQ(at_half({4, 0.5, 0.5, 0}), 8);
  EXPECT_DOUBLE_EQ(at_half({0.5, 0.5, 0.5, 0.5}), 9);
  EXPECT_DOUBLE_EQ(at_half({0.5, 0.4, 0.3, 0.2}), 6);
  EXPECT_DOUBLE_EQ(at_half({4, 3, 2, 0.5}), 9);
}

TEST(Threshold, RoundingOfSumsDoesNotMoveAnExactHit) {
  const double third = 1.0 / 3;
  EXPECT_DOUBLE_EQ(at_half({4, third + third / 2 - 1e-16, third + third / 2 - 1e-16, 0}), 8);
}

TEST(Threshold, FlatPartsOffTheLevelDoNotMatter) {
  EXPECT_DOUBLE_EQ(at_half({1, 1, 0, 0}), 7.5);
}

TEST(Threshold, ValueAtIsTheInverse) {
  const std::vector<double> fit = {4, 1, 0.25, 0};
  EXPECT_DOUBLE_EQ(value_at(four_octaves, fit, at_half(fit)), 0.5);
  EXPECT_DOUBLE_EQ(value_at(four_octaves, fit, 5), 4);
  EXPECT_DOUBLE_EQ(value_at(four_octaves, fit, 10), 0);
}

}  // namespace
}  // namespace seamline::analysis
