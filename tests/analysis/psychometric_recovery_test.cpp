// Planted parameters are found again, and the pieces keep their laws.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/psychometric/intervals/bootstrap_intervals.h"
#include "analysis/psychometric/intervals/fit_intervals.h"
#include "analysis/psychometric/intervals/goodness.h"
#include "analysis/psychometric/likelihood/binomial_sampler.h"
#include "analysis/psychometric/likelihood/overdispersion.h"

namespace seamline::analysis {
using namespace study;
namespace {

const std::vector<double> tested_widths_px = {64, 128, 256, 512, 1024, 2048, 4096};

std::vector<LevelCounts> simulate(const PsychometricFunction& function, std::int64_t trials, Random& random) {
  std::vector<LevelCounts> counts;
  for (double px : tested_widths_px)
    counts.push_back({.level = px,
                      .correct = sample_binomial(trials, response_probability(function, px), random),
                      .trials = trials});
  return counts;
}

PsychometricFunction falling(Sigmoid sigmoid) {
  return {.sigmoid = sigmoid,
          .axis = Axis::log2,
          .direction = Direction::decreasing,
          .threshold = 420,
          .scale = 0.6,
          .guess = 1.0 / 3,
          .lapse = 0.03};
}

TEST(PsychometricRecovery, ThreeAlternativesThatFallWithWidth) {
  for (const Sigmoid sigmoid : every_sigmoid) {
    const PsychometricFunction truth = falling(sigmoid);
    FitOptions options = options_for_alternatives(3);
    options.sigmoid = sigmoid;
    double error = 0, squares = 0;
    int covered = 0;
    constexpr int sets = 200;
    for (std::uint64_t seed = 1; seed <= sets; ++seed) {
      Random random(seed);
      const PsychometricFit fit = fit_psychometric(simulate(truth, 200, random), options);
      ASSERT_EQ(fit.direction, Direction::decreasing);
      EXPECT_TRUE(fit.direction_known);
      const double octaves = std::log2(fit.function.threshold / truth.threshold);
      error += octaves / sets;
      squares += octaves * octaves / sets;
      const Interval ci95 = threshold_interval(fit);
      covered += ci95.low <= truth.threshold && truth.threshold <= ci95.high ? 1 : 0;
    }
    EXPECT_LT(std::abs(error), 0.03);
    EXPECT_LT(std::sqrt(squares), 0.2);
    EXPECT_GE(covered, 0.90 * sets);
    EXPECT_LE(covered, 0.99 * sets);
  }
}

TEST(PsychometricRecovery, NoClimbFromAnywhereBeatsTheReportedMaximum) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed, 5);
    FitOptions options = options_for_alternatives(1 + static_cast<int>(random.below(4)));
    options.sigmoid = static_cast<Sigmoid>(random.below(3));
    options.axis = static_cast<Axis>(random.below(2));
    options.direction = static_cast<Direction>(random.below(2));
    const auto trials = static_cast<std::int64_t>(1 + std::exp2(7 * random.uniform()));
    std::vector<LevelCounts> counts;
    for (std::uint64_t i = 0; i < 2 + seed % 9; ++i)
      counts.push_back({.level = std::exp2(static_cast<double>(i) + 0.8 * random.uniform()),
                        .correct = random.binomial(static_cast<int>(trials), random.uniform()),
                        .trials = trials});
    const PsychometricFit fit = fit_psychometric(counts, options);
    const FitProblem& problem = fit.search.problem;
    for (int start = 0; start < 40; ++start) {
      const Theta theta{2 * random.uniform() - 1, std::log(0.01) + 6 * random.uniform(),
                        problem.upper[parameter::lapse] * random.uniform(), options.guess.low};
      EXPECT_LE(maximise(problem, {}, theta, 0).value, fit.search.best.value + 1e-6) << "seed " << seed;
    }
  }
}

TEST(PsychometricRecovery, FallingDataAreTheMirrorOfRisingOnes) {
  Random random(3);
  std::vector<LevelCounts> counts = simulate(falling(Sigmoid::gumbel), 40, random);
  FitOptions options = options_for_alternatives(3);
  options.sigmoid = Sigmoid::gumbel;
  const PsychometricFit fit = fit_psychometric(counts, options);
  for (LevelCounts& row : counts) row.level = 1 / row.level;
  const PsychometricFit mirror = fit_psychometric(counts, options);
  EXPECT_EQ(mirror.direction, Direction::increasing);
  EXPECT_NEAR(mirror.function.threshold * fit.function.threshold, 1, 1e-6);
  EXPECT_NEAR(mirror.width, fit.width, 1e-6);
  EXPECT_NEAR(mirror.log_likelihood, fit.log_likelihood, 1e-9);
}

TEST(PsychometricRecovery, YesNoWithAFreeGuessRate) {
  PsychometricFunction truth = falling(Sigmoid::normal);
  truth.guess = 0.15;
  Random random(11);
  FitOptions options = options_for_alternatives(1);
  options.guess = free_rate(0.5);
  const PsychometricFit fit = fit_psychometric(simulate(truth, 20000, random), options);
  EXPECT_NEAR(fit.function.guess, 0.15, 0.01);
  EXPECT_NEAR(std::log2(fit.function.threshold / truth.threshold), 0, 0.03);
  const Interval guess = guess_interval(fit), lapse = lapse_interval(fit);
  EXPECT_TRUE(guess.low < 0.15 && 0.15 < guess.high);
  EXPECT_TRUE(lapse.low < 0.03 && 0.03 < lapse.high);
}

TEST(PsychometricRecovery, TheLevelOfAPercentageIsWhereTheFunctionHasIt) {
  Random random(5);
  const PsychometricFit fit =
      fit_psychometric(simulate(falling(Sigmoid::logistic), 60, random), options_for_alternatives(3));
  for (double correct : {0.4, 2.0 / 3, 0.9}) {
    const LevelEstimate level = level_of_correct(fit, correct);
    ASSERT_TRUE(level.estimate);
    EXPECT_NEAR(fitted_probability(fit, *level.estimate), correct, 1e-9);
    EXPECT_LT(level.ci95.low, *level.estimate);
    EXPECT_GT(level.ci95.high, *level.estimate);
  }
  EXPECT_FALSE(level_of_correct(fit, 0.2).estimate);
}

TEST(PsychometricRecovery, BootstrapAgreesWithTheProfileWhereBothAreGood) {
  Random random(2);
  FitOptions options = options_for_alternatives(3);
  options.lapse = fixed_rate(0.03);
  const PsychometricFit fit = fit_psychometric(simulate(falling(Sigmoid::normal), 400, random), options);
  const BootstrapIntervals bootstrap =
      bootstrap_intervals(fit, {.replicates = 2000, .seed = 9, .correct = 0.7});
  const Interval profile = threshold_interval(fit), width = width_interval(fit);
  const double octaves = std::log2(profile.high / profile.low);
  EXPECT_NEAR(std::log2(bootstrap.threshold.low / profile.low), 0, 0.1 * octaves);
  EXPECT_NEAR(std::log2(bootstrap.threshold.high / profile.high), 0, 0.1 * octaves);
  EXPECT_NEAR(bootstrap.width.low, width.low, 0.1 * (width.high - width.low));
  EXPECT_NEAR(bootstrap.width.high, width.high, 0.1 * (width.high - width.low));
  ASSERT_TRUE(bootstrap.level_of_correct);
  EXPECT_NEAR(std::log2(bootstrap.level_of_correct->low / level_of_correct(fit, 0.7).ci95.low), 0, 0.05);
  const BootstrapIntervals again = bootstrap_intervals(fit, {.replicates = 2000, .seed = 9, .correct = 0.7});
  EXPECT_EQ(again.threshold.low, bootstrap.threshold.low);
}

TEST(PsychometricRecovery, DeviancePIsUniformWhenTheModelIsTrue) {
  int below_half = 0, below_tenth = 0;
  constexpr int sets = 200;
  for (std::uint64_t seed = 1; seed <= sets; ++seed) {
    Random random(seed, 1);
    const double p = deviance_p(
        fit_psychometric(simulate(falling(Sigmoid::normal), 60, random), options_for_alternatives(3)), 99,
        seed);
    below_half += p <= 0.5 ? 1 : 0;
    below_tenth += p <= 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(below_half, 0.5 * sets, 4 * std::sqrt(0.25 * sets));
  EXPECT_NEAR(below_tenth, 0.1 * sets, 4 * std::sqrt(0.09 * sets));
}

TEST(PsychometricRecovery, OverdispersionOfRowsIsFoundAndWidensIntervals) {
  // Rows whose probability varies with eta = 0.3: p is drawn for each row among three values.
  constexpr double eta = 0.3;
  Random random(4);
  std::vector<LevelCounts> counts;
  for (int block = 0; block < 12; ++block)
    for (double px : tested_widths_px) {
      const double p = response_probability(falling(Sigmoid::normal), px);
      const double spread = eta * std::sqrt(p * (1 - p));
      const double drawn = std::clamp(random.uniform() < 0.5 ? p - spread : p + spread, 0.0, 1.0);
      counts.push_back({.level = px, .correct = random.binomial(40, drawn), .trials = 40});
    }
  FitOptions options = options_for_alternatives(3);
  const PsychometricFit fit = fit_psychometric(counts, options);
  const OverdispersionEstimate found = estimate_overdispersion(fit);
  ASSERT_TRUE(found.eta);
  EXPECT_NEAR(*found.eta, eta, 0.08);
  EXPECT_GT(found.ci95.low, 0.15);
  EXPECT_LT(found.ci95.high, 0.45);
  options.overdispersed = true;
  const PsychometricFit wide = fit_psychometric(counts, options);
  EXPECT_NEAR(wide.eta, *found.eta, 1e-3);
  EXPECT_GT(wide.log_likelihood, fit.log_likelihood + 10);
  const Interval binomial = threshold_interval(fit), beta_binomial = threshold_interval(wide);
  // Variance is larger by 1 + 39 eta^2 = 4.5: the interval by 2.1.
  const double ratio =
      std::log2(beta_binomial.high / beta_binomial.low) / std::log2(binomial.high / binomial.low);
  EXPECT_GT(ratio, 1.5);
  EXPECT_LT(ratio, 2.8);
}

TEST(PsychometricRecovery, APriorPullsAndAStrongOneWins) {
  Random random(6);
  const auto counts = simulate(falling(Sigmoid::normal), 10, random);
  FitOptions options = options_for_alternatives(3);
  const PsychometricFit free = fit_psychometric(counts, options);
  options.priors.threshold = NormalPrior{.mean = 1000, .sd = 0.001};
  options.priors.log2_width = NormalPrior{.mean = 1, .sd = 0.001};
  options.priors.lapse = BetaPrior{.a = 1, .b = 10};
  const PsychometricFit pulled = fit_psychometric(counts, options);
  EXPECT_NEAR(std::log2(pulled.function.threshold / 1000), 0, 0.001);
  EXPECT_NEAR(pulled.width, 2, 0.01);
  EXPECT_LE(pulled.function.lapse, free.function.lapse + 0.1);
  EXPECT_LT(pulled.log_likelihood, free.log_likelihood);
  options.priors.threshold->sd = -1;
  EXPECT_ANY_THROW((void)fit_psychometric(counts, options));
}

}  // namespace
}  // namespace seamline::analysis
