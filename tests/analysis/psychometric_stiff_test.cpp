// Data that break fits: each has an expected verdict or value, and none gets a confident number it has not
// earned.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "analysis/psychometric/intervals/judged_fit.h"
#include "analysis/psychometric/report/fit_json.h"
#include "laboratory/stability/statistics/curve_fit_cases.h"
#include "support/arithmetic/random.h"
#include "support/text/error.h"

namespace seamline::analysis {
using namespace study;
using namespace stability;
namespace {

using Kind = Verdict::Kind;
using ::testing::Contains;
using ::testing::HasSubstr;

JudgedFit report_of(const std::vector<LevelCounts>& counts, const FitOptions& options, int replicates = 200) {
  return judge_fit(counts, options, {.deviance_replicates = replicates, .unit = "px"});
}

TEST(PsychometricStiff, AllRightIsABoundWhenTheDirectionIsGiven) {
  const auto counts = counts_at_widths(60, [](double) { return 1.0; });
  const JudgedFit report = report_of(counts, falling_choice_of_three());
  EXPECT_EQ(report.verdict.kind, Kind::above);
  EXPECT_EQ(report.verdict.text, "above 4096 px");
  EXPECT_EQ(report.threshold_ci95.high, INFINITY);

  FitOptions rising = falling_choice_of_three();
  rising.direction = Direction::increasing;
  EXPECT_EQ(report_of(counts, rising).verdict.text, "below 64 px");

  rising.direction.reset();
  const JudgedFit unknown = report_of(counts, rising);
  EXPECT_EQ(unknown.verdict.kind, Kind::not_identified);
  EXPECT_THAT(unknown.verdict.text, HasSubstr("ceiling"));
}

TEST(PsychometricStiff, AllChanceIsNotIdentified) {
  const auto counts = counts_at_widths(60, [](double) { return 1.0 / 3; });
  for (bool direction_given : {true, false}) {
    FitOptions options = falling_choice_of_three();
    if (!direction_given) options.direction.reset();
    const JudgedFit report = report_of(counts, options);
    EXPECT_EQ(report.verdict.text, "not identified: every level at chance");
    EXPECT_EQ(report.verdict.kind, Kind::not_identified);
  }
}

TEST(PsychometricStiff, FlatBetweenChanceAndCeilingAndBelowChanceAreNotIdentified) {
  EXPECT_THAT(
      report_of(counts_at_widths(60, [](double) { return 0.7; }), falling_choice_of_three()).verdict.text,
      HasSubstr("does not change with level"));
  EXPECT_THAT(
      report_of(counts_at_widths(60, [](double) { return 0.1; }), falling_choice_of_three()).verdict.text,
      HasSubstr("below chance"));
}

TEST(PsychometricStiff, PerfectStepIsAnIntervalOfLevels) {
  const auto counts = counts_at_widths(60, [](double px) { return px < 300 ? 1.0 : 1.0 / 3; });
  const JudgedFit report = report_of(counts, falling_choice_of_three());
  EXPECT_EQ(report.verdict.kind, Kind::between);
  EXPECT_EQ(report.verdict.text, "between 256 and 512 px");
  EXPECT_NEAR(report.threshold_ci95.low, 256, 1);
  EXPECT_NEAR(report.threshold_ci95.high, 512, 1);
  EXPECT_EQ(report.width_ci95.low, 0);
  EXPECT_LT(report.width_ci95.high, 3);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("separation")));
  EXPECT_NEAR(report.fit.log_likelihood, 4 * (20 * std::log(1.0 / 3) + 40 * std::log(2.0 / 3)), 1e-9);
}

TEST(PsychometricStiff, StepThroughALevelIsANumberNearIt) {
  const auto counts = counts_at_widths(60, [](double px) {
    return px < 200 ? 1.0 : px < 300 ? 0.7 : 1.0 / 3;
  });
  // F is 0.55 at 256 px: the threshold lies a little beyond, the less the steeper the function.
  const JudgedFit report = report_of(counts, falling_choice_of_three());
  EXPECT_EQ(report.verdict.kind, Kind::identified);
  ASSERT_TRUE(report.threshold);
  EXPECT_GT(*report.threshold, 256);
  EXPECT_LT(*report.threshold, 270);
  EXPECT_LT(report.threshold_ci95.low, 256);
  EXPECT_GT(report.threshold_ci95.high, 270);
  EXPECT_LT(report.threshold_ci95.high, 400);
  EXPECT_EQ(report.width_ci95.low, 0);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("a step through 256")));
}

TEST(PsychometricStiff, AStepThroughTheLastLevelIsANumberToo) {
  // It once said "above 2048", without an estimate, beside an interval of 3152.9 to 4095.5.
  std::vector<LevelCounts> counts = counts_at_widths(60, [](double) { return 1.0; });
  counts.back().correct = 30;
  const JudgedFit report = report_of(counts, falling_choice_of_three());
  EXPECT_EQ(report.verdict.kind, Kind::identified);
  ASSERT_TRUE(report.threshold);
  EXPECT_NEAR(report.threshold_ci95.low, 3153, 10);
  EXPECT_NEAR(report.threshold_ci95.high, 4096, 1);
  EXPECT_GT(*report.threshold, report.threshold_ci95.low);
  EXPECT_LT(*report.threshold, report.threshold_ci95.high);
}

TEST(PsychometricStiff, OneLevelAndNoTrials) {
  EXPECT_EQ(report_of({{.level = 64, .correct = 20, .trials = 30}}, falling_choice_of_three()).verdict.text,
            "not identified: one level tested");
  const JudgedFit report = report_of({{.level = 64}, {.level = 128}}, falling_choice_of_three());
  EXPECT_EQ(report.verdict.text, "not identified: no trials");
  EXPECT_FALSE(fit_json(report).empty());
}

TEST(PsychometricStiff, TwoLevels) {
  // Chance and ceiling: somewhere between. In the middle of the rise, without lapses: a number, and a
  // warning.
  const JudgedFit separated =
      report_of({{.level = 64, .correct = 60, .trials = 60}, {.level = 4096, .correct = 20, .trials = 60}},
                falling_choice_of_three());
  EXPECT_EQ(separated.verdict.text, "between 64 and 4096 px");
  FitOptions options = falling_choice_of_three();
  options.lapse = fixed_rate(0);
  const JudgedFit rise = report_of(
      {{.level = 256, .correct = 180, .trials = 200}, {.level = 1024, .correct = 100, .trials = 200}},
      options);
  EXPECT_EQ(rise.verdict.kind, Kind::identified);
  EXPECT_NEAR(rise.goodness.deviance, 0, 1e-9);
  EXPECT_THAT(rise.warnings, Contains(HasSubstr("two levels")));
}

TEST(PsychometricStiff, OneTrialALevel) {
  std::vector<LevelCounts> counts = counts_at_widths(1, [](double px) { return px < 300 ? 1.0 : 0.0; });
  const JudgedFit few = report_of(counts, falling_choice_of_three());
  // A step between 256 and 512 by its looks; seven answers do not say so.
  EXPECT_EQ(few.verdict.kind, Kind::between);
  EXPECT_LT(few.verdict.range.low, 150);
  EXPECT_GT(few.verdict.range.high, 800);
  EXPECT_THAT(few.warnings, Contains(HasSubstr("tiny counts: 7 trials")));
  EXPECT_FALSE(few.overdispersion.eta);

  // 400 levels of one trial each do identify it.
  counts.clear();
  Random random(7);
  for (int i = 0; i < 400; ++i) {
    const double px = 32 * std::exp2(8.0 * i / 399);
    counts.push_back({.level = px,
                      .correct = random.binomial(1, response_probability(planted_function(0.02), px)),
                      .trials = 1});
  }
  const JudgedFit many = report_of(counts, falling_choice_of_three(), 0);
  EXPECT_LE(many.threshold_ci95.low, 500);
  EXPECT_GE(many.threshold_ci95.high, 500);
  EXPECT_TRUE(std::isfinite(many.threshold_ci95.high));
}

TEST(PsychometricStiff, RowsWithoutTrialsChangeNothing) {
  auto counts =
      counts_at_widths(60, [](double px) { return response_probability(planted_function(0.02), px); });
  const double threshold = fit_psychometric(counts, falling_choice_of_three()).function.threshold;
  counts.insert(counts.begin() + 3, {.level = 300});
  counts.insert(counts.begin() + 4, {.level = 301});
  counts.push_back({.level = 1e6});
  const JudgedFit report = report_of(counts, falling_choice_of_three());
  EXPECT_DOUBLE_EQ(report.fit.function.threshold, threshold);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("3 rows without a trial")));
}

TEST(PsychometricStiff, NonMonotoneDataAreAMisfitWithEvidence) {
  const std::vector<LevelCounts> counts = {{64, 58, 60},   {128, 30, 60},  {256, 57, 60}, {512, 25, 60},
                                           {1024, 48, 60}, {2048, 20, 60}, {4096, 22, 60}};
  const JudgedFit report = report_of(counts, falling_choice_of_three(), 999);
  EXPECT_LT(report.deviance_p, 0.01);
  EXPECT_THAT(report.warnings,
              Contains(::testing::AllOf(HasSubstr("misfit: deviance"), HasSubstr("not monotone"))));
  EXPECT_THAT(report.warnings, Contains(HasSubstr("overdispersed")));
}

TEST(PsychometricStiff, AMillionTrialsALevel) {
  const auto counts =
      counts_at_widths(1'000'000, [](double px) { return response_probability(planted_function(0.02), px); });
  const JudgedFit report = report_of(counts, falling_choice_of_three());
  EXPECT_EQ(report.verdict.kind, Kind::identified);
  EXPECT_NEAR(report.fit.function.threshold, 500, 0.01);
  EXPECT_NEAR(report.fit.function.scale, 0.8, 1e-5);
  EXPECT_NEAR(report.fit.function.lapse, 0.02, 1e-5);
  EXPECT_LT(std::log2(report.threshold_ci95.high / report.threshold_ci95.low), 0.015);
  EXPECT_GT(report.deviance_p, 0.9);  // the data are their own expectation
}

TEST(PsychometricStiff, LevelsFromAMillionthToAMillion) {
  std::vector<double> levels;
  for (int i = 0; i <= 12; ++i) levels.push_back(std::pow(10.0, i - 6));
  for (const Sigmoid sigmoid : every_sigmoid) {
    const PsychometricFunction function{.sigmoid = sigmoid,
                                        .axis = Axis::log2,
                                        .direction = Direction::increasing,
                                        .threshold = 0.02,
                                        .scale = 5,
                                        .guess = 0.5,
                                        .lapse = 0.03};
    FitOptions options = options_for_alternatives(2);
    options.sigmoid = sigmoid;
    const JudgedFit report = report_of(
        counts_at(levels, 100'000, [&](double x) { return response_probability(function, x); }), options, 0);
    EXPECT_EQ(report.verdict.kind, Kind::identified) << report.verdict.text;
    EXPECT_NEAR(report.fit.function.threshold, 0.02, 0.0002);
    EXPECT_NEAR(report.fit.function.scale, 5, 0.01);
    EXPECT_NEAR(report.fit.function.lapse, 0.03, 1e-3);
  }
  // The same levels on a linear axis: all but one lie within a tenth of the range. A step there.
  FitOptions linear = options_for_alternatives(2);
  linear.axis = Axis::linear;
  const JudgedFit report =
      report_of(counts_at(levels, 100, [](double x) { return x > 0.5 ? 1.0 : 0.5; }), linear, 0);
  EXPECT_EQ(report.verdict.text, "between 0.1 and 1 px");
}

TEST(PsychometricStiff, LapseOfAFifthHitsTheCapAndIsFoundWithAWiderOne) {
  const auto counts =
      counts_at_widths(2000, [](double px) { return response_probability(planted_function(0.2), px); });
  const JudgedFit capped = report_of(counts, falling_choice_of_three());
  EXPECT_EQ(capped.fit.function.lapse, 0.1);
  EXPECT_THAT(capped.warnings, Contains(HasSubstr("lapse rate is at its bound of 0.1")));
  FitOptions wider = falling_choice_of_three();
  wider.lapse = free_rate(0.5);
  const JudgedFit found = report_of(counts, wider);
  EXPECT_NEAR(found.fit.function.lapse, 0.2, 1e-3);
  EXPECT_NEAR(found.fit.function.threshold, 500, 2);
  EXPECT_LT(found.lapse_ci95.low, 0.2);
  EXPECT_GT(found.lapse_ci95.high, 0.2);
}

TEST(PsychometricStiff, AThresholdBeyondTheLevelsIsABoundOrAWarning) {
  PsychometricFunction far = planted_function(0);
  far.threshold = 20000;
  const JudgedFit report =
      report_of(counts_at_widths(60, [&](double px) { return response_probability(far, px); }),
                falling_choice_of_three());
  EXPECT_NE(report.verdict.kind, Kind::between);
  if (report.verdict.kind == Kind::identified) {
    EXPECT_THAT(report.warnings, Contains(HasSubstr("extrapolated")));
  } else {
    EXPECT_TRUE(report.verdict.kind == Kind::above || report.verdict.kind == Kind::not_identified);
  }
}

TEST(PsychometricStiff, WrongInputIsASentence) {
  EXPECT_THROW((void)fit_psychometric({{.level = -1, .correct = 1, .trials = 2}}, falling_choice_of_three()),
               InputError);
  EXPECT_THROW((void)fit_psychometric({{.level = 1, .correct = 3, .trials = 2}}, falling_choice_of_three()),
               InputError);
  EXPECT_THROW((void)fit_psychometric({{.level = NAN, .correct = 1, .trials = 2}}, falling_choice_of_three()),
               InputError);
  FitOptions options = falling_choice_of_three();
  options.lapse = fixed_rate(0.7);
  EXPECT_THROW((void)fit_psychometric({{.level = 1, .correct = 1, .trials = 2}}, options), InputError);
}

}  // namespace
}  // namespace seamline::analysis
