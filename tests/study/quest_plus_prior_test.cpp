// Priors that are not even, functions that rise, grids on a linear axis.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "quest_plus_task.h"
#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

Task task_of(const QuestPlusDefinition& definition, const std::vector<int>& width_px = seven_widths_px) {
  Task task{.definition = definition, .grid = make_grid(definition), .width_px = width_px, .tables = {}};
  task.tables = make_level_tables(task.definition, task.grid, {width_px.begin(), width_px.end()});
  return task;
}

QuestPlusDefinition usual() {
  return definition_for(seven_widths_px);
}

/// An outcome that the model gives at a point of another grid, the truth.
int answer_of(const Task& task, const QuestPlusGrid& truth, int width, Random& random) {
  double rest = random.uniform();
  int outcome = 0;
  for (const double p :
       outcome_probabilities(task.definition, truth, 0, task.width_px[static_cast<std::size_t>(width)])) {
    if (rest < p) return outcome;
    rest -= p;
    ++outcome;
  }
  return outcome - 1;
}

TEST(QuestPlusPrior, AnEvenOneIsWhatItWasBitForBit) {
  for (const PlacementOutcome outcome : {PlacementOutcome::correct, PlacementOutcome::noticeability}) {
    const Task task = make_task(outcome);
    EXPECT_EQ(prior_posterior(task.grid), uniform_posterior(task.grid.points()));
  }
}

TEST(QuestPlusPrior, ANormalOneIsOnTheAxisOfTheSteps) {
  QuestPlusDefinition definition = usual();
  definition.threshold.prior = NormalMass{.mean = 300, .sd = 0.7};
  const QuestPlusGrid octaves = make_grid(definition);
  const Moments on_log2 = moments(octaves, prior_posterior(octaves), Parameter::threshold);
  EXPECT_NEAR(on_log2.mean, std::log2(300), 1e-4);
  EXPECT_NEAR(on_log2.sd, 0.7, 1e-4);

  definition.axis = Axis::linear;
  definition.threshold = {.least = 0, .most = 1000, .count = 101, .prior = NormalMass{.mean = 420, .sd = 80}};
  const QuestPlusGrid linear = make_grid(definition);
  const Moments in_px = moments(linear, prior_posterior(linear), Parameter::threshold);
  EXPECT_NEAR(in_px.mean, 420, 1e-3);
  EXPECT_NEAR(in_px.sd, 80, 1e-3);
}

TEST(QuestPlusPrior, OfRatesAndListedOnes) {
  QuestPlusDefinition definition = usual();
  definition.lapse = {.least = 0, .most = 0.4, .count = 3, .prior = BetaMass{.a = 1, .b = 3}};
  definition.scale = {.least = 1, .most = 4, .count = 3, .prior = ListedMass{.weights = {1, 0, 3}}};
  const QuestPlusGrid grid = make_grid(definition);
  const QuestPlusPosterior prior = prior_posterior(grid);
  EXPECT_NEAR(std::accumulate(prior.mass.begin(), prior.mass.end(), 0.0), 1, 1e-12);
  const double sum = 1 + 0.64 + 0.36;  // (1 - v)^2
  EXPECT_THAT(marginal(grid, prior, Parameter::lapse),
              Pointwise(DoubleNear(1e-12), {1 / sum, 0.64 / sum, 0.36 / sum}));
  EXPECT_THAT(marginal(grid, prior, Parameter::scale), Pointwise(DoubleNear(1e-12), {0.25, 0.0, 0.75}));
  for (int point = 0; point < grid.points(); ++point) {  // a point's mass is the product of its values'
    double product = 1;
    for (const Parameter parameter : every_parameter)
      product *= prior_mass(grid, parameter, static_cast<std::size_t>(grid.index(parameter, point)));
    EXPECT_NEAR(prior.mass[static_cast<std::size_t>(point)], product, 1e-15);
  }
}

TEST(QuestPlusPrior, WhatIsRuledOutStaysOutAndWhatIsUnlikelyComesBack) {
  QuestPlusDefinition definition = usual();
  definition.scale.prior = ListedMass{.weights = {0, 1, 1, 1, 1, 1, 1, 1, 1}};
  definition.threshold.prior = NormalMass{.mean = 32, .sd = 0.1};  // masses down to exp(-3200)
  const Task task = task_of(definition);
  QuestPlusPosterior posterior = prior_posterior(task.grid);
  for (int trial = 0; trial < 20000; ++trial) learn(posterior, task.tables, 6, trial % 3 == 0 ? 0 : 1);
  EXPECT_EQ(marginal(task.grid, posterior, Parameter::scale).front(), 0);
  EXPECT_GT(moments(task.grid, posterior, Parameter::threshold).mean, 10);
  for (const double value : expected_entropies_nats(task.tables, posterior)) EXPECT_TRUE(value >= -1e-9);
}

/// Watson's equation 6 as it is written: the entropy after each outcome, weighted with its probability.
std::vector<double> entropies_as_written(const Task& task, const std::vector<double>& mass) {
  std::vector<double> expected;
  for (const int width_px : task.width_px) {
    std::vector<std::vector<double>> joint(static_cast<std::size_t>(task.tables.outcomes));
    for (int point = 0; point < task.grid.points(); ++point) {
      const std::vector<double> p = outcome_probabilities(task.definition, task.grid, point, width_px);
      for (std::size_t o = 0; o < joint.size(); ++o)
        joint[o].push_back(p[o] * mass[static_cast<std::size_t>(point)]);
    }
    expected.push_back(0);
    for (std::vector<double>& outcome : joint) {
      const double share = std::accumulate(outcome.begin(), outcome.end(), 0.0);
      for (double& value : outcome) value /= share;
      expected.back() += share * entropy_nats(outcome);
    }
  }
  return expected;
}

TEST(QuestPlusPrior, ASequenceIsThatOfBayesRuleAsItIsWritten) {
  QuestPlusDefinition definition = usual();
  definition.threshold = {.least = 32, .most = 8192, .count = 21, .prior = NormalMass{.mean = 300, .sd = 1}};
  definition.scale = {.least = 0.25, .most = 1, .count = 3, .values = {0.25, 0.3, 1}};
  definition.scale.prior = ListedMass{.weights = {1, 2, 1}};
  definition.lapse.prior = BetaMass{.a = 2, .b = 30};
  for (const Direction direction : {Direction::decreasing, Direction::increasing}) {
    definition.direction = direction;
    const Task task = task_of(definition);
    QuestPlusPosterior posterior = prior_posterior(task.grid);
    std::vector<double> mass = posterior.mass;
    Random random(3, 0);
    for (int trial = 0; trial < 30; ++trial) {
      const std::vector<double> expected = entropies_as_written(task, mass);
      EXPECT_THAT(expected_entropies_nats(task.tables, posterior), Pointwise(DoubleNear(1e-10), expected));
      const int width = task.best(posterior), outcome = random.uniform() < 0.6 ? 1 : 0;
      learn(posterior, task.tables, width, outcome);
      double sum = 0;
      for (int point = 0; point < task.grid.points(); ++point)
        sum += mass[static_cast<std::size_t>(point)] *= outcome_probabilities(
            definition, task.grid, point,
            task.width_px[static_cast<std::size_t>(width)])[static_cast<std::size_t>(outcome)];
      for (double& value : mass) value /= sum;
      EXPECT_THAT(posterior.mass, Pointwise(DoubleNear(1e-12), mass));
    }
  }
}

/// Root mean square error (octaves) of 100 people about 300 px, after `trials`.
double error_after(const QuestPlusDefinition& definition, int trials) {
  const Task task = task_of(definition);
  double squares = 0;
  constexpr int people = 100;
  for (int person = 0; person < people; ++person) {
    Random random(41, static_cast<std::uint64_t>(person));
    const double planted = std::log2(300) + 0.5 * random.normal();
    const QuestPlusGrid truth{.values = {{{planted}, {0.5}, {0.02}, {1.0 / 3}, {0.4}}}};
    QuestPlusPosterior posterior = prior_posterior(task.grid);
    for (int trial = 0; trial < trials; ++trial) {
      const int width = task.best(posterior);
      learn(posterior, task.tables, width, answer_of(task, truth, width, random));
    }
    const double error = moments(task.grid, posterior, Parameter::threshold).mean - planted;
    squares += error * error / people;
  }
  return std::sqrt(squares);
}

TEST(QuestPlusPrior, AGoodOneSavesTrialsAndAWrongOneIsOvercome) {
  QuestPlusDefinition even = usual();
  even.scale.count = 5;
  even.lapse.count = 3;
  QuestPlusDefinition good = even, wrong = even;
  good.threshold.prior = NormalMass{.mean = 300, .sd = 0.6};
  wrong.threshold.prior = NormalMass{.mean = 1200, .sd = 0.6};
  for (const Direction direction : {Direction::decreasing, Direction::increasing}) {
    even.direction = good.direction = wrong.direction = direction;
    const double even_early = error_after(even, 20), even_late = error_after(even, 150);
    const double good_early = error_after(good, 20), good_late = error_after(good, 150);
    const double wrong_early = error_after(wrong, 20), wrong_late = error_after(wrong, 600);
    std::printf(
        "rms error (octaves) after 20 and 150 (wrong: 600) trials: even %.3f %.3f, good %.3f %.3f, wrong "
        "%.3f %.3f\n",
        even_early, even_late, good_early, good_late, wrong_early, wrong_late);
    EXPECT_LT(good_early, 0.8 * even_early);
    EXPECT_GT(wrong_early, even_early);
    EXPECT_LT(good_late, 0.3);
    EXPECT_LT(even_late, 0.3);
    EXPECT_LT(wrong_late, 0.3);
  }
}

/// Alarms compare with the prior: one that begins at an edge does not ring there before it has learnt.
TEST(QuestPlusPrior, IsNoAlarmOfItself) {
  QuestPlusDefinition definition = usual();
  definition.threshold.prior = NormalMass{.mean = 32, .sd = 0.3};
  Task task = task_of(definition);
  QuestPlusPosterior posterior = prior_posterior(task.grid);
  EXPECT_GT(marginal(task.grid, posterior, Parameter::threshold).front(), 0.3);
  EXPECT_TRUE(edge_alarms(task.grid, posterior, 0.1).empty());
  for (int trial = 0; trial < 60; ++trial) learn(posterior, task.tables, 0, 0);
  EXPECT_FALSE(edge_alarms(task.grid, posterior, 0.1).empty());
}

TEST(QuestPlusAxis, StepsAreEqualWhereTheStudySaysSo) {
  QuestPlusDefinition definition = usual();
  definition.axis = Axis::linear;
  definition.threshold = {.least = 10, .most = 50, .count = 5};
  definition.scale = {.least = 1, .most = 7, .count = 4, .steps = Steps::equal};
  definition.lapse = {.least = 0, .most = 0.05, .count = 3, .values = {0, 0.02, 0.05}};
  QuestPlusGrid grid = make_grid(definition);
  EXPECT_THAT(grid.of(Parameter::threshold), ElementsAre(10, 20, 30, 40, 50));
  EXPECT_THAT(grid.of(Parameter::scale), ElementsAre(1, 3, 5, 7));
  EXPECT_THAT(grid.of(Parameter::lapse), ElementsAre(0, 0.02, 0.05));
  definition.threshold.steps = Steps::ratios;
  EXPECT_NEAR(make_grid(definition).of(Parameter::threshold)[2], std::sqrt(500), 1e-12);
  definition.axis = Axis::log2;
  definition.threshold.steps = Steps::equal;
  grid = make_grid(definition);
  EXPECT_DOUBLE_EQ(grid.of(Parameter::threshold)[1], std::log2(20));
}

TEST(QuestPlusAxis, OutcomesOnALinearAxis) {
  QuestPlusDefinition definition = usual();
  definition.axis = Axis::linear;
  definition.outcome = PlacementOutcome::noticeability;
  for (const Direction direction : {Direction::decreasing, Direction::increasing}) {
    definition.direction = direction;
    const double d = direction == Direction::increasing ? 1 : -1;
    const QuestPlusGrid point{.values = {{{500}, {80}, {0.04}, {0.25}, {60}}}};
    for (const int width_px : seven_widths_px) {
      const std::vector<double> p = outcome_probabilities(definition, point, 0, width_px);
      const auto seen = [&](double steps) {
        return 1 / (1 + std::exp(-d * (width_px - 500 - d * steps * 60) / 80));
      };
      EXPECT_NEAR(1 - p[0], 0.25 + (0.75 - 0.04) * seen(0), 1e-12);
      EXPECT_NEAR(p[4], (1 - 0.04 / 0.75) * seen(3), 1e-12);
      EXPECT_NEAR(p[3], (1 - 0.04 / 0.75) * (seen(2) - seen(3)), 1e-12);
    }
  }
}

TEST(QuestPlusAxis, FindsThePlantedThresholdOfALinearFunction) {
  QuestPlusDefinition definition = usual();
  definition.axis = Axis::linear;
  definition.threshold = {.least = 0, .most = 4000, .count = 81};
  definition.scale = {.least = 50, .most = 800, .count = 7};
  const std::vector<int> widths = {400, 800, 1200, 1600, 2000, 2400, 2800, 3200, 3600};
  for (const Direction direction : {Direction::decreasing, Direction::increasing}) {
    definition.direction = direction;
    const Task task = task_of(definition, widths);
    double bias_px = 0;
    for (int person = 0; person < 40; ++person) {
      Random random(51, static_cast<std::uint64_t>(person));
      const double planted_px = 1000 + 2000 * random.uniform();
      const QuestPlusGrid truth{.values = {{{planted_px}, {200}, {0.02}, {1.0 / 3}, {0}}}};
      QuestPlusPosterior posterior = prior_posterior(task.grid);
      for (int trial = 0; trial < 120; ++trial) {
        const int width = task.best(posterior);
        learn(posterior, task.tables, width, answer_of(task, truth, width, random));
      }
      const Moments found = moments(task.grid, posterior, Parameter::threshold);
      EXPECT_NEAR(found.mean, planted_px, 4.5 * found.sd + 25);
      bias_px += (found.mean - planted_px) / 40;
    }
    EXPECT_NEAR(bias_px, 0, 60);
  }
}

/// What is learnt of a rising function is the mirror image of what is learnt of the falling one.
TEST(QuestPlusAxis, ARisingFunctionMirrorsTheFallingOne) {
  for (const Axis axis : {Axis::log2, Axis::linear})
    for (const PlacementOutcome outcome : {PlacementOutcome::correct, PlacementOutcome::noticeability})
      for (const Sigmoid sigmoid : every_sigmoid) {
        QuestPlusDefinition falling = usual();
        falling.axis = axis;
        falling.outcome = outcome;
        falling.sigmoid = sigmoid;
        falling.threshold.count = 17;
        falling.scale.count = 3;
        falling.lapse.count = 2;
        std::vector<int> widths = seven_widths_px;  // and the thresholds: symmetric about the axis' middle
        if (axis == Axis::linear) {
          widths = {100, 200, 300, 400, 500, 600, 700};
          falling.threshold = {0, 800, 17};
          falling.scale = {20, 200, 3};
          falling.rating_step = {20, 80, 2};
        }
        std::vector<double> weights(17);
        for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = 1 + static_cast<double>(i % 5 + i);
        falling.threshold.prior = ListedMass{.weights = weights};
        QuestPlusDefinition rising = falling;
        rising.direction = Direction::increasing;
        rising.threshold.prior = ListedMass{.weights = {weights.rbegin(), weights.rend()}};
        const Task one = task_of(falling, widths), other = task_of(rising, widths);
        QuestPlusPosterior of_one = prior_posterior(one.grid), of_other = prior_posterior(other.grid);
        Random random(7, 0);
        for (int trial = 0; trial < 60; ++trial) {
          std::vector<double> expected = expected_entropies_nats(one.tables, of_one);
          std::reverse(expected.begin(), expected.end());
          ASSERT_THAT(expected_entropies_nats(other.tables, of_other), Pointwise(DoubleNear(1e-9), expected));
          const auto width = static_cast<int>(random.below(widths.size()));
          const auto answer = static_cast<int>(random.below(static_cast<std::uint64_t>(one.tables.outcomes)));
          learn(of_one, one.tables, width, answer);
          learn(of_other, other.tables, static_cast<int>(widths.size()) - 1 - width, answer);
          std::vector<double> mass = marginal(one.grid, of_one, Parameter::threshold);
          std::reverse(mass.begin(), mass.end());
          ASSERT_THAT(marginal(other.grid, of_other, Parameter::threshold),
                      Pointwise(DoubleNear(1e-9), mass));
          for (const Parameter parameter : {Parameter::scale, Parameter::lapse, Parameter::rating_step})
            ASSERT_THAT(marginal(other.grid, of_other, parameter),
                        Pointwise(DoubleNear(1e-9), marginal(one.grid, of_one, parameter)));
        }
      }
}

}  // namespace
}  // namespace seamline::study
