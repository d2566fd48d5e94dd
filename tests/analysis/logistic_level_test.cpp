#include "analysis/statistics/logistic_level.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/thresholds/angular_resolution.h"
#include "analysis/thresholds/closed_estimates.h"
#include "tests/analysis/octaves.h"

namespace seamline::analysis {
namespace {

using test::octaves;

/// What is said of a level read off a logistic, without an interval.
ThresholdEstimate logistic_level_estimate(double level, const Logistic4Fit& fit,
                                          const std::vector<double>& level_x) {
  return estimate_in(logistic_level_range(level, fit, level_x), fit, level_x, {});
}

Logistic4Fit fitted(const std::vector<double>& means) {
  return Logistic4Fitter(octaves).fit(means);
}

TEST(LogisticLevel, IsWhereTheCurveHasTheLevel) {
  const Logistic4 planted{.upper = 3.6, .lower = 0.3, .centre_x = 8.3, .scale_x = 0.7};
  std::vector<double> means;
  for (double x : octaves) means.push_back(value_at(planted, x));
  for (double level : {0.5, 1.0, 2.0}) {
    const ThresholdEstimate found = logistic_level_estimate(level, fitted(means), octaves);
    ASSERT_TRUE(found.level_x) << level;
    EXPECT_NEAR(value_at(planted, *found.level_x), level, 1e-4);
  }
}

TEST(LogisticLevel, SaysWhenTheCurveNeverCrosses) {
  EXPECT_EQ(logistic_level_estimate(0.5, fitted({4, 3.8, 3, 2, 1.4, 1.2, 1.1}), octaves).reason,
            NoThreshold::curve_above);
  EXPECT_EQ(logistic_level_estimate(3.9, fitted({3.5, 3.3, 3, 2, 1.4, 1.2, 1.1}), octaves).reason,
            NoThreshold::curve_below);
  EXPECT_EQ(logistic_level_estimate(0.5, fitted(std::vector<double>(7, 1.0)), octaves).reason,
            NoThreshold::curve_above);
  EXPECT_EQ(logistic_level_estimate(1.5, fitted(std::vector<double>(7, 1.0)), octaves).reason,
            NoThreshold::curve_below);
}

TEST(LogisticLevel, OfAStepIsTheWholeGap) {
  const Logistic4Fit step = fitted({4, 4, 4, 0, 0, 0, 0});
  const LevelInterval range = logistic_level_range(0.5, step, octaves);
  EXPECT_DOUBLE_EQ(range.low_x, 8);
  EXPECT_DOUBLE_EQ(range.high_x, 9);
  EXPECT_FALSE(logistic_level_estimate(0.5, step, octaves).level_x);
}

TEST(LogisticLevel, OfTooFewWidthsIsEverything) {
  const std::vector<double> three = {6, 7, 8};
  const Logistic4Fit fit = Logistic4Fitter(three).fit(std::vector<double>{4, 2, 0});
  EXPECT_EQ(logistic_level_estimate(1, fit, three).reason, NoThreshold::under_four_levels);
  EXPECT_EQ(logistic_level_range(1, fit, three).high_x, above_every_level);
}

TEST(AngularResolution, OfAFieldOfView) {
  EXPECT_DOUBLE_EQ(texels_per_degree(720), 2);
  EXPECT_DOUBLE_EQ(width_in_field_of_view_px(720, 90), 180);
  // A narrow camera is the same either way; at 90 degrees a pinhole needs 2 / (pi / 2) times the texels.
  EXPECT_NEAR(pinhole_width_px(720, 1), width_in_field_of_view_px(720, 1), 1e-4);
  EXPECT_NEAR(pinhole_width_px(720, 90) / width_in_field_of_view_px(720, 90), 4 / std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace seamline::analysis
