// Each guard of the statistics and of QUEST+ is taken away, and the case that watches it must fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/ordinal/likelihood/fixed_likelihood.h"
#include "analysis/ordinal/likelihood/newton.h"
#include "analysis/psychometric/intervals/goodness.h"
#include "laboratory/stability/statistics/interval_cases.h"
#include "laboratory/stability/statistics/quest_plus_cases.h"
#include "laboratory/stability/statistics/rating_cases.h"

namespace seamline::stability {
using namespace analysis;
namespace {

TEST(StatisticsGuards, TheOptimumAloneIsNoIntervalOfAStep) {
  EXPECT_EQ(try_singular_information().error, 0);
  const IntervalRule pinned = [](const PsychometricFit& fit) {
    return Interval{.low = fit.function.threshold, .high = fit.function.threshold};
  };
  EXPECT_GT(try_singular_information(pinned).error, 0);
}

/// Quantiles of the thresholds that refits happened to end at.
BootstrapIntervals plain_percentiles(const PsychometricFit& fit, const BootstrapRequest& request) {
  std::vector<double> thresholds;
  BootstrapIntervals found{.threshold = {},
                           .width = {.low = 0},
                           .lapse = {},
                           .level_of_correct = {},
                           .replicates = request.replicates};
  for (int i = 0; i < request.replicates; ++i) {
    const FitProblem problem = simulated_problem(fit, request.seed, static_cast<std::uint64_t>(i));
    thresholds.push_back(
        std::exp2(problem.to_axis(refit(problem, fit.search.best).theta[parameter::threshold])));
  }
  std::sort(thresholds.begin(), thresholds.end());
  const std::size_t last = thresholds.size() - 1;
  found.threshold = {.low = thresholds[last / 40], .high = thresholds[last - last / 40]};
  return found;
}

TEST(StatisticsGuards, PlainPercentilesForgetTheRangeOfSteps) {
  EXPECT_EQ(try_degenerate_resamples().error, 0);
  EXPECT_GT(try_degenerate_resamples(plain_percentiles).error, 0);
}

/// A step through a level taken for one between its neighbours, all of it as likely.
BootstrapIntervals between_neighbours(const PsychometricFit& fit, const BootstrapRequest& request) {
  BootstrapIntervals found = bootstrap_intervals(fit, request);
  found.threshold = {.low = 128, .high = 512};
  return found;
}

TEST(StatisticsGuards, StepsThroughALevelAreNotStepsBetweenItsNeighbours) {
  EXPECT_EQ(try_steps_through_levels().error, 0);
  EXPECT_GE(try_steps_through_levels(between_neighbours).error, 3);
}

/// Fits until it stops, and reports where it is.
OrdinalFit newton_alone(const OrdinalData& data) {
  const OrdinalProblem problem = prepare(data, false);
  OrdinalFit fit;
  fit.verdict = OrdinalVerdict::estimated;
  if (problem.cuts() < 1) return fit;
  const NewtonResult result =
      maximise([&](const Eigen::VectorXd& at) { return fixed_likelihood(problem, Link::logit, at, 1); },
               null_parameters(problem, Link::logit), 30);
  fit.coefficients = result.at.tail(problem.x.cols());
  return fit;
}

TEST(StatisticsGuards, NewtonAloneGivesNumbersWhereThereIsNoMaximum) {
  EXPECT_EQ(try_separation().error, 0);
  EXPECT_GE(try_separation(newton_alone).error, 2);
  EXPECT_EQ(try_singular_design().error, 0);
  EXPECT_EQ(try_singular_design(newton_alone).error, 3);
}

double probability(const QuestPlusTables& tables, int stimulus, int outcome, std::size_t point) {
  const double log_probability =
      tables.log_probability[static_cast<std::size_t>(stimulus * tables.outcomes + outcome) *
                                 static_cast<std::size_t>(tables.points) +
                             point];
  return log_probability < -690 ? 0 : std::exp(log_probability);
}

/// Bayes' rule on masses, without logarithms.
void learn_masses(QuestPlusPosterior& posterior, const QuestPlusTables& tables, int stimulus, int outcome) {
  double sum = 0;
  for (std::size_t point = 0; point < posterior.mass.size(); ++point)
    sum += posterior.mass[point] *= probability(tables, stimulus, outcome, point);
  for (double& mass : posterior.mass) mass /= sum;
}

/// The same, normalised only when looked at.
void learn_products(QuestPlusPosterior& posterior, const QuestPlusTables& tables, int stimulus, int outcome) {
  for (std::size_t point = 0; point < posterior.mass.size(); ++point)
    posterior.mass[point] *= probability(tables, stimulus, outcome, point);
}

TEST(QuestPlusGuards, ProductsOfProbabilitiesUnderflow) {
  EXPECT_LE(try_many_trials().error, 1e-12);
  EXPECT_FALSE(try_many_trials(learn_products).error <= 1e-12);
}

TEST(QuestPlusGuards, MassesWithoutLogarithmsDoNotComeBack) {
  EXPECT_EQ(try_point_comes_back().error, 0);
  EXPECT_GT(try_point_comes_back(learn_masses).error, 0);
}

TEST(QuestPlusGuards, AnImpossibleAnswerDividesByZeroWithoutAFloor) {
  EXPECT_LE(try_impossible_answer().error, 1e-12);
  EXPECT_FALSE(try_impossible_answer(learn_masses).error <= 1e-12);
}

TEST(QuestPlusGuards, WithoutTheAlarmNobodyHearsOfTheEdge) {
  EXPECT_EQ(try_edge().error, 0);
  EXPECT_EQ(try_edge(1).error, 2);
}

}  // namespace
}  // namespace seamline::stability
