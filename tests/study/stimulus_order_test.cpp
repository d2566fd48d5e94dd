#include "study/trials/stimulus_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// Chi-squared statistic of counts that should be equal.
double chi_squared(const std::vector<int>& counts) {
  const double expected =
      std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
  double sum = 0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

/// 0.999 quantile of chi-squared (Wilson and Hilferty); the seeds are fixed, so a test either always passes
/// or never.
double chi_squared_limit(double degrees) {
  const double part = 2 / (9 * degrees);
  return degrees * std::pow(1 - part + 3.0902 * std::sqrt(part), 3);
}

TEST(StimulusOrder, ShowsEveryStimulusOnce) {
  for (const int count : {0, 1, 2, 84, 5000})
    for (int slot = 0; slot < 5; ++slot) {
      std::vector<int> order = stimulus_order(count, {.study_seed = 3, .slot = slot});
      std::sort(order.begin(), order.end());
      std::vector<int> expected(static_cast<std::size_t>(count));
      std::iota(expected.begin(), expected.end(), 0);
      EXPECT_EQ(order, expected);
    }
}

TEST(StimulusOrder, IsTheSameForTheSameKeyAndDiffersBetweenSlotsAndSeeds) {
  std::set<std::vector<int>> orders;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (int slot = 0; slot < 100; ++slot) {
      const OrderKey key{.study_seed = seed, .slot = slot};
      orders.insert(stimulus_order(84, key));
      EXPECT_EQ(stimulus_order(84, key), stimulus_order(84, key));
    }
  EXPECT_EQ(orders.size(), 2000U);
}

TEST(StimulusOrder, NeverChangesBetweenVersionsAndMachines) {
  EXPECT_THAT(stimulus_order(12, {.study_seed = 1, .slot = 0}),
              testing::ElementsAre(3, 6, 7, 1, 0, 2, 4, 11, 5, 8, 10, 9));
  EXPECT_THAT(stimulus_order(12, {.study_seed = 1, .slot = 1}),
              testing::ElementsAre(8, 6, 9, 11, 4, 0, 10, 5, 3, 7, 2, 1));
}

TEST(StimulusOrder, EveryOrderIsEquallyLikely) {
  std::map<std::vector<int>, int> seen;
  for (int slot = 0; slot < 24000; ++slot) ++seen[stimulus_order(4, {.study_seed = 11, .slot = slot})];
  std::vector<int> counts;
  for (const auto& [order, count] : seen) counts.push_back(count);
  ASSERT_EQ(counts.size(), 24U);
  EXPECT_LT(chi_squared(counts), chi_squared_limit(23));
}

TEST(StimulusOrder, EveryStimulusIsEquallyLikelyAtEveryPlace) {
  constexpr int stimuli = 84;
  std::vector<int> counts(stimuli * stimuli, 0);
  for (int slot = 0; slot < 20000; ++slot) {
    const std::vector<int> order = stimulus_order(stimuli, {.study_seed = 5, .slot = slot});
    for (std::size_t place = 0; place < order.size(); ++place)
      ++counts[place * stimuli + static_cast<std::size_t>(order[place])];
  }
  EXPECT_LT(chi_squared(counts), chi_squared_limit((stimuli - 1) * (stimuli - 1)));
}

TEST(Random, BelowIsUniformForBoundsThatDoNotDivideTheRange) {
  constexpr int seeds = 50;
  for (const std::uint64_t bound : {2U, 3U, 7U, 84U, 1000U}) {
    double sum = 0;  // of independent statistics: chi-squared with the degrees added up
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      Random random(seed, bound);
      std::vector<int> counts(bound, 0);
      for (int draw = 0; draw < 20000; ++draw) ++counts[random.below(bound)];
      sum += chi_squared(counts);
    }
    EXPECT_LT(sum, chi_squared_limit(seeds * static_cast<double>(bound - 1))) << bound;
  }
}

TEST(Random, BelowHasNoModuloBiasForALargeBound) {
  // For 3 * 2^62 a plain remainder would land in the first third half of the time.
  Random random(9);
  std::vector<int> thirds(3, 0);
  for (int draw = 0; draw < 100000; ++draw) ++thirds[random.below(3ULL << 62) >> 62];
  EXPECT_LT(chi_squared(thirds), chi_squared_limit(2));
}

}  // namespace
}  // namespace seamline::study
