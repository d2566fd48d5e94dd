// Laws of a fit over many simulated sets; the long run with its table is
// psychometric_simulated_full_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/psychometric/intervals/fit_intervals.h"
#include "laboratory/stability/statistics/curve_fit_cases.h"
#include "study/placement/sigmoid_shape.h"
#include "tests/analysis/psychometric_simulated.h"

namespace seamline::analysis {
using namespace stability;
using namespace study;
namespace {

using test::contradiction;
using test::simulated_set;
using test::SimulatedSet;

JudgedFit report_of(const SimulatedSet& set, int replicates, std::uint64_t seed) {
  return judge_fit(
      set.counts, set.options,
      {.percents = {75, 40}, .bootstrap_replicates = replicates, .deviance_replicates = 0, .seed = seed});
}

TEST(PsychometricLaws, VerdictRangeEstimateAndIntervalsNeverContradict) {
  for (std::uint64_t seed = 0; seed < 240; ++seed)
    EXPECT_EQ(contradiction(report_of(simulated_set(1'000'000 + seed), 40, seed)), "") << seed;
}

/// Answers at a few levels without any law, many at an end of what is possible.
TEST(PsychometricLaws, NorDoThoseOfArbitraryCounts) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed, 0x617262697472ULL);
    SimulatedSet set;
    const auto levels = 1 + static_cast<int>(random.below(6));
    for (int i = 0; i < levels; ++i) {
      const auto trials = static_cast<std::int64_t>(random.below(random.uniform() < 0.3 ? 3 : 30));
      const double kind = random.uniform();
      const std::int64_t correct =
          kind < 0.35   ? trials
          : kind < 0.5  ? 0
          : kind < 0.65 ? trials / 3
                        : static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(trials) + 1));
      set.counts.push_back(
          {.level = std::exp2(3 * random.uniform() + i), .correct = correct, .trials = trials});
    }
    set.options = options_for_alternatives(1 + static_cast<int>(random.below(3)));
    set.options.sigmoid = static_cast<Sigmoid>(random.below(3));
    set.options.axis = random.uniform() < 0.5 ? Axis::linear : Axis::log2;
    if (random.uniform() < 0.7)
      set.options.direction = random.uniform() < 0.5 ? Direction::increasing : Direction::decreasing;
    if (random.uniform() < 0.2) set.options.guess = free_rate(0.3);
    EXPECT_EQ(contradiction(report_of(set, 20, seed)), "") << seed;
  }
}

/// The highest ln L of all functions with that threshold, by brute force over scale and lapse.
double profile_at(const FitProblem& problem, double threshold_t) {
  double best = -infinity;
  for (double scale = 3e-4; scale < 3; scale *= 1.25)
    for (int part = 0; part <= 10; ++part) {
      const Theta theta{threshold_t, std::log(scale), 0.1 * part * problem.upper[parameter::lapse],
                        problem.lower[parameter::guess]};
      best = std::max(best, log_likelihood(problem, theta, 0));
    }
  return best;
}

TEST(PsychometricLaws, NoThresholdBeyondAnEndOfTheIntervalIsWithinTheCut) {
  constexpr std::int64_t trials = 12;  // few answers leave the steep ridges through levels within the cut
  int outside = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed, 5);
    PsychometricFunction planted = planted_function(0.03);
    planted.threshold = std::exp2(7.5 + 3 * random.uniform());
    planted.scale = 0.2 + random.uniform();
    planted.guess = 0.5;
    std::vector<LevelCounts> counts = counts_at_widths(trials, [](double) { return 0.0; });
    for (LevelCounts& level : counts)
      level.correct = sample_binomial(trials, response_probability(planted, level.level), random);
    FitOptions options = options_for_alternatives(2);
    options.direction = Direction::decreasing;
    const PsychometricFit fit = fit_psychometric(counts, options);
    const FitProblem& problem = fit.search.problem;
    const Interval ci95 = threshold_interval(fit);
    const double needed = fit.search.best.value - chi_squared_95 / 2;
    for (double octaves : {0.01, 0.02, 0.04, 0.08, 0.12, 0.2, 0.35}) {
      if (ci95.low > 0 && std::isfinite(ci95.low))
        outside += profile_at(problem, problem.to_unit(std::log2(ci95.low) - octaves)) > needed ? 1 : 0;
      if (std::isfinite(ci95.high))
        outside += profile_at(problem, problem.to_unit(std::log2(ci95.high) + octaves)) > needed ? 1 : 0;
    }
  }
  EXPECT_EQ(outside, 0);
}

TEST(PsychometricLaws, BootstrapIntervalsDoNotSnapToTheLevels) {
  int ends = 0, at_levels = 0;
  double log2_lengths = 0, profile_lengths = 0;
  const PsychometricFunction planted{.sigmoid = Sigmoid::normal,
                                     .axis = Axis::log2,
                                     .direction = Direction::decreasing,
                                     .threshold = std::exp2(8.9),
                                     .scale = 0.35,
                                     .guess = 1.0 / 3,
                                     .lapse = 0.02};
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed, 3);
    std::vector<LevelCounts> counts = counts_at_widths(60, [](double) { return 0.0; });
    for (LevelCounts& level : counts)
      level.correct = sample_binomial(level.trials, response_probability(planted, level.level), random);
    const PsychometricFit fit = fit_psychometric(counts, falling_choice_of_three());
    const Interval ci95 = bootstrap_intervals(fit, {.replicates = 200, .seed = seed}).threshold;
    ASSERT_TRUE(test::is_closed(ci95));
    log2_lengths += std::log2(ci95.high / ci95.low);
    const Interval profile = threshold_interval(fit);
    profile_lengths += std::log2(profile.high / profile.low);
    if (fit.is_step && !fit.search.step->through_level) continue;  // holds the gap between two levels
    for (double end : {ci95.low, ci95.high}) {
      const double octaves = std::log2(end);
      at_levels += std::abs(octaves - std::round(octaves)) < 1e-4 ? 1 : 0;
      ++ends;
    }
  }
  EXPECT_LE(at_levels, ends / 20) << "of " << ends;
  EXPECT_LT(log2_lengths, 1.2 * profile_lengths);
}

}  // namespace
}  // namespace seamline::analysis
