#include "analysis/statistics/logistic4.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/scores/level_words.h"
#include "analysis/thresholds/closed_estimates.h"
#include "support/arithmetic/random.h"
#include "tests/analysis/octaves.h"

namespace seamline::analysis {
namespace {

using test::octaves;

std::vector<double> values_of(const Logistic4& curve) {
  std::vector<double> values;
  for (double x : octaves) values.push_back(value_at(curve, x));
  return values;
}

TEST(Logistic4, RecoversNoiselessCurves) {
  const Logistic4Fitter fitter(octaves);
  for (double centre : {6.5, 8.0, 9.3, 11.2})
    for (double scale : {0.35, 0.7, 1.2}) {
      const Logistic4 planted{.upper = 3.8, .lower = 0.35, .centre_x = centre, .scale_x = scale};
      const Logistic4Fit fit = fitter.fit(values_of(planted));
      EXPECT_EQ(fit.verdict, Centre::identified) << centre << " " << scale;
      EXPECT_NEAR(fit.curve.centre_x, centre, 1e-5);
      EXPECT_NEAR(fit.curve.scale_x, scale, 1e-5);
      EXPECT_NEAR(fit.curve.upper, 3.8, 1e-4);
      EXPECT_NEAR(fit.curve.lower, 0.35, 1e-4);
    }
}

/// No point of a fine grid may be better than the fit: it is the global optimum.
TEST(Logistic4, BeatsAFineGridOnNoisyData) {
  const Logistic4Fitter fitter(octaves);
  Random random(7);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> values = values_of({.upper = 4, .lower = 0.3, .centre_x = 8.5, .scale_x = 0.6});
    for (double& value : values) value += 0.4 * random.normal();
    const Logistic4Fit fit = fitter.fit(values);
    if (fit.verdict == Centre::step) continue;
    for (double centre = 6; centre <= 12; centre += 0.05)
      for (double scale = 0.12; scale < 6; scale *= 1.1) {
        double sf = 0, sff = 0, sy = 0, sfy = 0, syy = 0;
        for (std::size_t i = 0; i < octaves.size(); ++i) {
          const double f = 1 / (1 + std::exp((octaves[i] - centre) / scale));
          sf += f, sff += f * f, sy += values[i], sfy += f * values[i], syy += values[i] * values[i];
        }
        const double variance = sff - sf * sf / 7, covariance = sfy - sf * sy / 7;
        if (variance < 1e-9 || covariance <= 0) continue;
        EXPECT_LE(fit.residual_sum_of_squares, syy - sy * sy / 7 - covariance * covariance / variance + 1e-7);
      }
  }
}

TEST(Logistic4, AStepIsARangeNotANumber) {
  const Logistic4Fit fit = Logistic4Fitter(octaves).fit(std::vector<double>{4, 4, 4, 0, 0, 0, 0});
  EXPECT_EQ(fit.verdict, Centre::step);
  EXPECT_DOUBLE_EQ(fit.centre_range.low_x, 8);
  EXPECT_DOUBLE_EQ(fit.centre_range.high_x, 9);
  EXPECT_EQ(reason_text(centre_of(fit, octaves, {}), {}),
            "a step between 256 and 512: the widths tested do not say where");
}

TEST(Logistic4, SaysWhyThereIsNoCentre) {
  const Logistic4Fitter fitter(octaves);
  EXPECT_EQ(fitter.fit(std::vector<double>(7, 1.0)).verdict, Centre::not_falling);
  EXPECT_EQ(fitter.fit(std::vector<double>{0, 1, 2, 3, 3, 4, 4}).verdict, Centre::not_falling);
  EXPECT_EQ(fitter.fit(std::vector<double>{4, 2, 1, 0.5, 0.25, 0.125, 0.0625}).verdict, Centre::below_range);
  EXPECT_EQ(fitter.fit(std::vector<double>{4, 3.99, 3.98, 3.95, 3.9, 3.6, 2}).verdict, Centre::above_range);
  EXPECT_EQ(fitter.fit(std::vector<double>{6, 5, 4, 3, 2, 1, 0}).verdict, Centre::straight);
  EXPECT_EQ(Logistic4Fitter({6, 7, 8}).fit(std::vector<double>{4, 2, 0}).verdict, Centre::too_few_levels);
}

}  // namespace
}  // namespace seamline::analysis
