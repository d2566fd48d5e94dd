// The deviance and its p: a number only where it says something, whatever the trials a level.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/psychometric/intervals/judged_fit.h"
#include "analysis/psychometric/likelihood/binomial_sampler.h"
#include "analysis/psychometric/report/fit_text.h"

namespace seamline::analysis {
using namespace study;
namespace {

/// Yes/no answers on a linear axis, levels evenly over three widths of the function.
std::vector<LevelCounts> answers_at(int levels, int trials, double guess, double lapse, std::uint64_t seed) {
  const PsychometricFunction planted{.sigmoid = Sigmoid::normal,
                                     .axis = Axis::linear,
                                     .direction = Direction::increasing,
                                     .threshold = 0,
                                     .scale = 2,
                                     .guess = guess,
                                     .lapse = lapse};
  Random random(seed, 77);
  std::vector<LevelCounts> counts;
  for (int i = 0; i < levels; ++i) {
    const double level = -10 + 20.0 * i / (levels - 1);
    counts.push_back({.level = level,
                      .correct = sample_binomial(trials, response_probability(planted, level), random),
                      .trials = trials});
  }
  return counts;
}

/// A function without guesses and lapses, as a study may wrongly suppose.
FitOptions no_errors() {
  FitOptions options;
  options.axis = Axis::linear;
  options.direction = Direction::increasing;
  options.lapse = fixed_rate(0);
  return options;
}

double p_of(const std::vector<LevelCounts>& counts, int replicates = 99) {
  return deviance_p(fit_psychometric(counts, no_errors()), replicates, 1);
}

TEST(PsychometricGoodness, GroupsKeepEveryAnswerAndAreFewAndNotTiny) {
  for (const auto& [levels, trials] :
       {std::pair{7, 60}, {20, 5}, {21, 5}, {30, 2}, {400, 1}, {1001, 1}, {3000, 3}, {3, 1}}) {
    const PsychometricFit fit = fit_psychometric(answers_at(levels, trials, 0, 0, 5), no_errors());
    const Goodness goodness = goodness_of_fit(fit);
    double correct = 0, all = 0, squares = 0;
    for (const LevelGroup& group : goodness.groups) {
      EXPECT_TRUE(group.trials >= trials_of_group || goodness.groups.size() == 1) << levels;
      correct += group.correct;
      all += group.trials;
      squares += group.deviance_residual * group.deviance_residual;
    }
    double right = 0;
    for (const LevelCounts& level : fit.levels) right += static_cast<double>(level.correct);
    EXPECT_EQ(correct, right);
    EXPECT_EQ(all, levels * trials);
    EXPECT_LE(goodness.groups.size(), most_groups) << levels;
    EXPECT_NEAR(goodness.deviance, squares, 1e-9);
    EXPECT_EQ(goodness.degrees_of_freedom, static_cast<int>(goodness.groups.size()) - fit.free_parameters);
  }
}

TEST(PsychometricGoodness, LevelsOfEnoughTrialsAreGroupsOfTheirOwn) {
  const PsychometricFit fit = fit_psychometric(answers_at(20, 5, 0, 0, 2), no_errors());
  const Goodness goodness = goodness_of_fit(fit);
  ASSERT_EQ(goodness.groups.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i)
    EXPECT_NEAR(goodness.groups[i].deviance_residual, goodness.residuals[i].deviance_residual, 1e-9);
}

/// A thousand levels with one answer each and one level more are the same data, and say the same of the fit.
TEST(PsychometricGoodness, OneLevelMoreChangesNothing) {
  std::vector<LevelCounts> counts = answers_at(1001, 1, 0, 0, 3);
  const double more = p_of(counts);
  counts.pop_back();
  EXPECT_NEAR(p_of(counts), more, 0.15);
  EXPECT_GT(more, 0.02);
}

TEST(PsychometricGoodness, OfTheRightModelIsUniform) {
  constexpr int sets = 60;
  int below_half = 0, below_tenth = 0;
  for (std::uint64_t seed = 1; seed <= sets; ++seed) {
    const double p = p_of(answers_at(200, 1, 0, 0, seed), 49);
    below_half += p <= 0.5 ? 1 : 0;
    below_tenth += p <= 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(below_half, 0.5 * sets, 4 * std::sqrt(0.25 * sets));
  EXPECT_NEAR(below_tenth, 0.1 * sets, 4 * std::sqrt(0.09 * sets));
}

/// The deviance of single answers depends on the fit alone and flags no wrong model; in groups it does.
TEST(PsychometricGoodness, AWrongModelIsSeenInSingleAnswers) {
  constexpr int sets = 12;
  int flagged = 0;
  for (std::uint64_t seed = 1; seed <= sets; ++seed)
    flagged += p_of(answers_at(1000, 1, 0.1, 0.1, seed), 99) < 0.05 ? 1 : 0;
  EXPECT_GE(flagged, sets / 2);
}

TEST(PsychometricGoodness, IsNoNumberWhereThereIsNothingToTest) {
  for (const auto& [levels, trials] : {std::pair{2, 50}, {7, 1}}) {
    const JudgedFit judged =
        judge_fit(answers_at(levels, trials, 0, 0, 4), no_errors(), {.deviance_replicates = 99});
    EXPECT_TRUE(std::isnan(judged.deviance_p)) << levels;
    EXPECT_THAT(fit_text(judged), ::testing::HasSubstr("not tested")) << levels;
  }
}

}  // namespace
}  // namespace seamline::analysis
