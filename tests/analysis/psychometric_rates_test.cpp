// Equal rates at both ends, and level 0 on a log axis.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/psychometric/intervals/judged_fit.h"
#include "study/placement/sigmoid_shape.h"

namespace seamline::analysis {
namespace {

// Yes/no answers of nine people together at seven levels, in two conditions of a published experiment on
// subjective equality (360 answers a level). Maxima by scipy 1.10.1, Nelder-Mead from 27 starts, guess =
// lapse in [0, 0.1].
const std::vector<LevelCounts> condition_0 = {{1, 15, 360},    {3.5, 41, 360}, {6, 88, 360},
                                              {8.5, 196, 360}, {11, 265, 360}, {13.5, 312, 360},
                                              {16, 338, 360}};
const std::vector<LevelCounts> condition_32 = {{1, 40, 360},    {3.5, 54, 360}, {6, 118, 360},
                                               {8.5, 165, 360}, {11, 257, 360}, {13.5, 301, 360},
                                               {16, 334, 360}};

FitOptions equal_options() {
  FitOptions options;
  options.axis = study::Axis::linear;
  options.equal_rates = true;
  return options;
}

TEST(PsychometricRates, EqualRatesHaveScipysMaximum) {
  const PsychometricFit first = fit_psychometric(condition_0, equal_options());
  EXPECT_NEAR(first.function.threshold, 8.51947056, 1e-5);
  EXPECT_NEAR(first.function.scale, 3.70681487, 1e-5);
  EXPECT_NEAR(first.function.lapse, 0.03288088, 1e-6);
  EXPECT_EQ(first.function.guess, first.function.lapse);
  EXPECT_NEAR(first.log_likelihood, -1073.36358568, 1e-6);
  EXPECT_EQ(first.free_parameters, 3);
  const PsychometricFit second = fit_psychometric(condition_32, equal_options());
  EXPECT_NEAR(second.function.threshold, 8.46512348, 1e-5);
  EXPECT_NEAR(second.log_likelihood, -1227.06650690, 1e-6);
}

TEST(PsychometricRates, WithEqualRatesTheThresholdIsTheFiftyPercentPoint) {
  const JudgedFit fit =
      judge_fit(condition_32, equal_options(), {.percents = {50}, .deviance_replicates = 0});
  ASSERT_TRUE(fit.threshold && fit.percents.front().level.estimate);
  EXPECT_NEAR(*fit.percents.front().level.estimate, *fit.threshold, 1e-9);
  EXPECT_NEAR(fit.percents.front().level.ci95.low, fit.threshold_ci95.low, 1e-3);
  EXPECT_NEAR(fit.percents.front().level.ci95.high, fit.threshold_ci95.high, 1e-3);
  EXPECT_EQ(fit.guess_ci95.low, fit.lapse_ci95.low);
  EXPECT_EQ(fit.guess_ci95.high, fit.lapse_ci95.high);
}

/// "No" instead of "yes" turns the function round and changes nothing else.
TEST(PsychometricRates, EqualRatesDoNotCareWhichAnswerIsYes) {
  std::vector<LevelCounts> turned = condition_0;
  for (LevelCounts& row : turned) row.correct = row.trials - row.correct;
  const JudgedFit yes = judge_fit(condition_0, equal_options(), {.deviance_replicates = 0}),
                  no = judge_fit(turned, equal_options(), {.deviance_replicates = 0});
  EXPECT_EQ(no.fit.direction, study::Direction::decreasing);
  EXPECT_NEAR(*yes.threshold, *no.threshold, 1e-6);
  EXPECT_NEAR(yes.threshold_ci95.low, no.threshold_ci95.low, 1e-4);
  EXPECT_NEAR(yes.threshold_ci95.high, no.threshold_ci95.high, 1e-4);
  EXPECT_NEAR(yes.fit.log_likelihood, no.fit.log_likelihood, 1e-8);
}

// Level 0 is what blank trials are: 2 of 84 seen.
const std::vector<LevelCounts> with_blanks = {{0, 2, 84},  {2, 2, 12},  {3, 6, 12},  {4, 9, 12},
                                              {5, 12, 12}, {6, 10, 12}, {7, 12, 12}, {8, 10, 12}};

FitOptions free_options() {
  FitOptions options;
  options.guess = free_rate(0.5);
  return options;
}

TEST(PsychometricRates, LevelZeroOnALogAxisIsTheGuessRate) {
  const JudgedFit fit = judge_fit(with_blanks, free_options(), {.deviance_replicates = 50});
  ASSERT_TRUE(fit.threshold);
  double sum = 0;
  for (const LevelCounts& row : with_blanks) {
    const double F =
        row.level == 0 ? 0
                       : study::sigmoid_value(Sigmoid::normal,
                                              (std::log2(row.level) - std::log2(fit.fit.function.threshold)) /
                                                  fit.fit.function.scale);
    const double p = fit.fit.function.guess + (1 - fit.fit.function.guess - fit.fit.function.lapse) * F;
    sum += static_cast<double>(row.correct) * std::log(p) +
           static_cast<double>(row.trials - row.correct) * std::log1p(-p);
  }
  EXPECT_NEAR(fit.fit.log_likelihood, sum, 1e-6);
  EXPECT_EQ(fit.goodness.residuals.size(), with_blanks.size());
  EXPECT_EQ(fit.goodness.residuals.front().counts.level, 0);
  EXPECT_NEAR(fit.goodness.residuals.front().fitted, fit.fit.function.guess, 1e-12);
  EXPECT_GT(fit.guess_ci95.low, 0);
  EXPECT_LT(fit.guess_ci95.high, 0.1);
}

/// A level so low that nothing is seen there says what level 0 says.
TEST(PsychometricRates, LevelZeroIsTheLimitOfFaintLevels) {
  const PsychometricFit none = fit_psychometric(with_blanks, free_options());
  std::vector<LevelCounts> faint = with_blanks;
  faint.front().level = 1e-3;
  const PsychometricFit nearly = fit_psychometric(faint, free_options());
  EXPECT_NEAR(none.log_likelihood, nearly.log_likelihood, 1e-6);
  EXPECT_NEAR(none.function.threshold, nearly.function.threshold, 1e-4);
}

TEST(PsychometricRates, AnswersWithoutAStimulusBelongToNoLevel) {
  const JudgedFit fit = judge_fit({{0, 5, 10}}, free_options(), {.deviance_replicates = 0});
  EXPECT_EQ(fit.verdict.kind, Verdict::Kind::not_identified);
}

}  // namespace
}  // namespace seamline::analysis
