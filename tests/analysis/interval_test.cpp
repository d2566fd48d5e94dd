#include "analysis/statistics/interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "analysis/scores/level_words.h"
#include "analysis/thresholds/closed_estimates.h"
#include "analysis/thresholds/thresholds.h"
#include "support/text/numbers.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

using test::Population;
using test::simulate_scores;
using test::thresholds_of_expected_means;

bool holds(const LevelInterval& interval, double level_x) {
  return interval.low_x <= level_x && level_x <= interval.high_x;
}

TEST(Interval, HoldsThePlantedValueIn88To100PercentOf50Seeds) {
  const Population population;
  for (Artifact artifact : paper_artifacts) {
    const CurveThresholds planted = thresholds_of_expected_means(population, artifact);
    int pt = 0, sn = 0, ip = 0;
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      const ArtifactThresholds found = estimate_thresholds(simulate_scores(population, artifact, 20, seed),
                                                           {.replicates = 500, .seed = seed});
      pt += holds(found.estimates.perceptual.ci95, *planted.perceptual.level_x) ? 1 : 0;
      sn += holds(found.estimates.slightly_noticeable.ci95, *planted.slightly_noticeable.level_x) ? 1 : 0;
      ip += holds(found.estimates.inflection.ci95, *planted.inflection.level_x) ? 1 : 0;
    }
    EXPECT_GE(pt, 44) << word(artifact);
    EXPECT_GE(sn, 44) << word(artifact);
    EXPECT_GE(ip, 42) << word(artifact);
  }
}

TEST(Interval, BiasWith2000ObserversIsUnderAFiftiethOfAnOctave) {
  const Population population;
  for (Artifact artifact : paper_artifacts) {
    const CurveThresholds planted = thresholds_of_expected_means(population, artifact);
    double pt = 0, sn = 0;
    constexpr int studies = 20;
    for (std::uint64_t seed = 1; seed <= studies; ++seed) {
      const CurveThresholds found =
          estimate_thresholds(simulate_scores(population, artifact, 2000, seed), {.replicates = 0}).estimates;
      pt += *found.perceptual.level_x - *planted.perceptual.level_x;
      sn += *found.slightly_noticeable.level_x - *planted.slightly_noticeable.level_x;
    }
    EXPECT_LT(std::abs(pt / studies), 0.02) << word(artifact);
    EXPECT_LT(std::abs(sn / studies), 0.02) << word(artifact);
  }
}

TEST(Interval, IsTheSameForAnyNumberOfThreads) {
  const ArtifactScores scores = simulate_scores({}, Artifact::occlusion, 20, 3);
  const auto with_threads = [&](int threads) {
    return estimate_thresholds(scores, {.replicates = 777, .seed = 5, .threads = threads});
  };
  const ArtifactThresholds one = with_threads(1);
  for (int threads : {2, 3, 8}) {
    const ArtifactThresholds many = with_threads(threads);
    EXPECT_EQ(one.estimates.inflection.ci95.low_x, many.estimates.inflection.ci95.low_x);
    EXPECT_EQ(one.estimates.inflection.ci95.high_x, many.estimates.inflection.ci95.high_x);
    EXPECT_EQ(one.perceptual_bootstrap.low_x, many.perceptual_bootstrap.low_x);
    EXPECT_EQ(one.slightly_noticeable_bootstrap.high_x, many.slightly_noticeable_bootstrap.high_x);
  }
}

ArtifactScores everyone_says(const std::vector<double>& values, int people) {
  ArtifactScores scores = simulate_scores({}, Artifact::receiver, people, 1);
  for (std::size_t w = 0; w < values.size(); ++w) {
    scores.noticeability.col(static_cast<Eigen::Index>(w)).setConstant(values[w]);
    scores.cells[w].mean = values[w];
  }
  return scores;
}

TEST(Interval, PerfectObserversAreAboveEveryWidth) {
  const ArtifactThresholds found =
      estimate_thresholds(everyone_says({4, 4, 4, 4, 4, 4, 4}, 20), {.replicates = 200});
  EXPECT_FALSE(found.estimates.perceptual.level_x);
  EXPECT_EQ(found.estimates.perceptual.reason, NoThreshold::curve_above);
  EXPECT_EQ(found.estimates.perceptual.ci95.low_x, above_every_level);
  EXPECT_EQ(found.estimates.perceptual.ci95.high_x, above_every_level);
  EXPECT_FALSE(found.estimates.inflection.level_x);
}

TEST(Interval, UnanimityGivesAPoint) {
  const ArtifactThresholds found =
      estimate_thresholds(everyone_says({4, 4, 3, 1, 0, 0, 0}, 20), {.replicates = 200});
  EXPECT_DOUBLE_EQ(*found.estimates.slightly_noticeable.level_x, 9);
  EXPECT_NEAR(found.estimates.slightly_noticeable.ci95.low_x, 9, 1e-9);
  EXPECT_NEAR(found.estimates.slightly_noticeable.ci95.high_x, 9, 1e-9);
}

TEST(Interval, OfOnePersonIsOpen) {
  const ArtifactThresholds found =
      estimate_thresholds(everyone_says({4, 4, 3, 1, 0, 0, 0}, 1), {.replicates = 200});
  EXPECT_EQ(found.estimates.perceptual.ci95.low_x, below_every_level);
  EXPECT_EQ(found.estimates.perceptual.ci95.high_x, above_every_level);
}

/// The rule of all of `analyze`: an estimate exactly where its interval is closed, inside it; else words.
TEST(ClosedEstimates, AreThereExactlyWhereTheIntervalIsClosed) {
  int closed = 0, open = 0;
  for (const int people : {2, 3, 5, 12, 40})
    for (const Artifact artifact : paper_artifacts)
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const CurveThresholds found =
            estimate_thresholds(simulate_scores({}, artifact, people, seed), {.replicates = 99}).estimates;
        for (const ThresholdEstimate* estimate :
             {&found.perceptual, &found.slightly_noticeable, &found.inflection, &found.perceptual_logistic,
              &found.slightly_noticeable_logistic}) {
          const bool is_closed = length_x(estimate->ci95).has_value();
          ASSERT_EQ(estimate->level_x.has_value(), is_closed) << people << " people, seed " << seed;
          ASSERT_EQ(estimate->reason.has_value(), !is_closed) << reason_text(*estimate, {});
          if (is_closed) {
            EXPECT_LE(estimate->ci95.low_x, *estimate->level_x);
            EXPECT_GE(estimate->ci95.high_x, *estimate->level_x);
          }
          (is_closed ? closed : open) += 1;
        }
      }
  EXPECT_GT(closed, 100);
  EXPECT_GT(open, 100);
}

TEST(ClosedEstimates, SayABoundWhereOneSideIsOpen) {
  const auto verdict = [](double low_x, double high_x) {
    ThresholdEstimate estimate{.level_x = 9, .reason = {}, .ci95 = {.low_x = low_x, .high_x = high_x}};
    keep_closed(estimate, {.low_x = 9, .high_x = 9}, {});
    return estimate.level_x ? std::string("an estimate") : reason_text(estimate, {});
  };
  EXPECT_EQ(verdict(8, 10), "an estimate");
  EXPECT_EQ(verdict(8, above_every_level), "above 256");
  EXPECT_EQ(verdict(below_every_level, 10), "below 1024");
  EXPECT_EQ(verdict(below_every_level, above_every_level), "not determined: no width is excluded");
  ThresholdEstimate step{.level_x = {}, .reason = NoThreshold::step, .ci95 = {.low_x = 8.2, .high_x = 9}};
  keep_closed(step, {.low_x = 8, .high_x = 9}, {});
  EXPECT_DOUBLE_EQ(step.level_x.value(), 8.5);
  EXPECT_FALSE(step.reason);
  EXPECT_DOUBLE_EQ(step.ci95.low_x, 8);
}

TEST(LevelInterval, HasALengthExactlyWhereItIsClosed) {
  EXPECT_DOUBLE_EQ(length_x({.low_x = 8, .high_x = 9.5}).value(), 1.5);
  for (const LevelInterval& open : {LevelInterval{}, LevelInterval{.low_x = 8}, LevelInterval{.high_x = 8},
                                    LevelInterval{.low_x = above_every_level, .high_x = above_every_level},
                                    LevelInterval{.low_x = below_every_level, .high_x = below_every_level}})
    EXPECT_FALSE(length_x(open));
  EXPECT_THROW((void)distance_between(above_every_level, above_every_level), std::logic_error);
  EXPECT_THROW((void)distance_between(below_every_level, below_every_level), std::logic_error);
  EXPECT_EQ(distance_between(above_every_level, below_every_level), above_every_level);
}

TEST(Quantile, RefusesWhatHasNoOrder) {
  std::vector<double> values = {1, nan, 2};
  EXPECT_THROW((void)quantile(values, 0.5), std::logic_error);
}

TEST(VarianceFunction, IsLinearBetweenMeansAndConstantBeyond) {
  MeanVector means;
  means.mean = Eigen::Vector3d(3, 2, 0);
  means.covariance = Eigen::Vector3d(0.1, 0.5, 0.3).asDiagonal();
  const VarianceFunction variance(fit_non_increasing({means.mean.data(), 3}), means);
  EXPECT_DOUBLE_EQ(variance.at(4), 0.1);
  EXPECT_DOUBLE_EQ(variance.at(2.5), 0.3);
  EXPECT_DOUBLE_EQ(variance.at(2), 0.5);
  EXPECT_DOUBLE_EQ(variance.at(1), 0.4);
  EXPECT_DOUBLE_EQ(variance.at(-1), 0.3);
}

TEST(Quantile, TakesInfiniteReplicatesAsTheyAre) {
  std::vector<double> values = {1, above_every_level, 2, below_every_level, 3};
  EXPECT_EQ(quantile(values, 0), below_every_level);
  EXPECT_EQ(quantile(values, 0.5), 2);
  EXPECT_EQ(quantile(values, 1), above_every_level);
  EXPECT_DOUBLE_EQ(quantile(values, 0.375), 1.5);
}

TEST(ExpandedLevels, AreHesterbergsAtTwenty) {
  EXPECT_NEAR(expanded_levels(20).low, 0.0159, 5e-4);
  EXPECT_NEAR(expanded_levels(1000000).low, 0.025, 1e-5);
}

}  // namespace
}  // namespace seamline::analysis
