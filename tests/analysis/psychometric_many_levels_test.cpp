// More levels than a fit looks at one by one.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/psychometric/intervals/judged_fit.h"
#include "analysis/psychometric/likelihood/binomial_sampler.h"
#include "analysis/psychometric/likelihood/level_bins.h"

namespace seamline::analysis {
using namespace study;
namespace {

std::vector<LevelCounts> simulated(int levels, double scale) {
  const PsychometricFunction planted{.sigmoid = Sigmoid::normal,
                                     .axis = Axis::log2,
                                     .direction = Direction::decreasing,
                                     .threshold = 500,
                                     .scale = scale,
                                     .guess = 1.0 / 3,
                                     .lapse = 0.02};
  Random random(7);
  std::vector<LevelCounts> counts;
  for (int i = 0; i < levels; ++i) {
    const double px = 64 * std::exp2(6 * (i + random.uniform()) / levels);
    counts.push_back(
        {.level = px, .correct = sample_binomial(3, response_probability(planted, px), random), .trials = 3});
  }
  return counts;
}

TEST(PsychometricManyLevels, AHundredThousandAreFittedInBinsThatChangeNothing) {
  const JudgedFit report = judge_fit(simulated(100'000, 0.8), options_for_alternatives(3), {});
  EXPECT_LE(report.fit.search.problem.levels.size(), most_unpooled_levels);
  EXPECT_EQ(report.goodness.residuals.size(), 100'000U);
  ASSERT_TRUE(report.threshold);
  EXPECT_LE(report.threshold_ci95.low, 510);
  EXPECT_GE(report.threshold_ci95.high, 490);
  EXPECT_NEAR(*report.threshold, 500, 10);
  EXPECT_NEAR(report.fit.function.scale, 0.8, 0.03);
  EXPECT_GT(report.deviance_p, 1e-4);
  EXPECT_FALSE(report.overdispersion.reason.empty());
}

TEST(PsychometricManyLevels, ASteepFunctionAmongThemIsLookedAtCloser) {
  const JudgedFit report =
      judge_fit(simulated(100'000, 0.002), options_for_alternatives(3), {.deviance_replicates = 0});
  ASSERT_TRUE(report.threshold);
  EXPECT_NEAR(std::log2(*report.threshold / 500), 0, 0.004);
}

TEST(PsychometricManyLevels, BinsKeepEveryAnswer) {
  std::vector<UnitCounts> levels;
  for (int i = 0; i < 10'000; ++i)
    levels.push_back({.t = i / 10'000.0 - 0.5, .k = static_cast<double>(i % 3), .n = 3});
  const std::vector<UnitCounts> bins = pooled_into_bins(levels, {.low = 0.1, .high = 0.15});
  double k = 0, n = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    k += bins[i].k;
    n += bins[i].n;
    if (i > 0) {
      EXPECT_LT(bins[i - 1].t, bins[i].t);
    }
  }
  EXPECT_LE(bins.size(), most_unpooled_levels);
  EXPECT_EQ(n, 30'000);
  EXPECT_EQ(k, 9'999);
}

}  // namespace
}  // namespace seamline::analysis
