// What holds for any task: expected entropies, long runs, answers that contradict each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "quest_plus_task.h"
#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// As the definition says: for each outcome the posterior after it, its entropy, and its probability.
double expected_entropy_directly(const QuestPlusTables& tables, const QuestPlusPosterior& posterior,
                                 int stimulus) {
  double expected = 0;
  for (int outcome = 0; outcome < tables.outcomes; ++outcome) {
    double probability = 0;
    for (int point = 0; point < tables.points; ++point)
      probability += posterior.mass[static_cast<std::size_t>(point)] *
                     std::exp(tables.log_probability[static_cast<std::size_t>(
                         (stimulus * tables.outcomes + outcome) * tables.points + point)]);
    QuestPlusPosterior after = posterior;
    learn(after, tables, stimulus, outcome);
    expected += probability * entropy_nats(after.mass);
  }
  return expected;
}

double total(const QuestPlusPosterior& posterior) {
  return std::accumulate(posterior.mass.begin(), posterior.mass.end(), 0.0);
}

TEST(QuestPlusPosterior, ExpectedEntropiesAreThoseOfTheDefinition) {
  for (const PlacementOutcome outcome : {PlacementOutcome::correct, PlacementOutcome::noticeability}) {
    const Task task = make_task(outcome);
    QuestPlusPosterior posterior = uniform_posterior(task.grid.points());
    Random random(3);
    for (int trial = 0; trial < 12; ++trial) {
      const std::vector<double> expected = expected_entropies_nats(task.tables, posterior);
      ASSERT_EQ(expected.size(), task.width_px.size());
      for (int stimulus = 0; stimulus < task.tables.stimuli; ++stimulus)
        EXPECT_NEAR(expected[static_cast<std::size_t>(stimulus)],
                    expected_entropy_directly(task.tables, posterior, stimulus), 1e-11);
      learn(posterior, task.tables, static_cast<int>(random.below(task.width_px.size())),
            static_cast<int>(random.below(static_cast<std::uint64_t>(task.tables.outcomes))));
    }
  }
}

TEST(QuestPlusPosterior, AStimulusThatTellsNothingKeepsTheEntropy) {
  const QuestPlusTables tables =
      make_quest_plus_tables(2, 2, 3, [](int stimulus, int point) -> std::vector<double> {
        if (stimulus == 0) return {0.25, 0.75};
        return {point / 2.0, 1 - point / 2.0};
      });
  const std::vector<double> expected = expected_entropies_nats(tables, uniform_posterior(3));
  EXPECT_NEAR(expected[0], std::log(3), 1e-14);
  EXPECT_LT(expected[1], std::log(3) - 0.3);
}

TEST(QuestPlusPosterior, FiveThousandTrialsDoNotUnderflow) {
  const Task task = make_task(PlacementOutcome::correct);
  // A person on the grid, so that there is a true point.
  int truth = 0;
  while (task.grid.index(Parameter::threshold, truth) != 20 ||
         task.grid.index(Parameter::scale, truth) != 4 || task.grid.index(Parameter::lapse, truth) != 1)
    ++truth;
  QuestPlusPosterior posterior = uniform_posterior(task.grid.points());
  Random random(11);
  for (int trial = 0; trial < 5000; ++trial) {
    const int stimulus = task.best(posterior);
    const double right = std::exp(
        task.tables
            .log_probability[static_cast<std::size_t>((stimulus * 2 + 1) * task.tables.points + truth)]);
    learn(posterior, task.tables, stimulus, random.uniform() < right ? 1 : 0);
    ASSERT_NEAR(total(posterior), 1, 1e-12);
  }
  const double threshold = task.grid.value(Parameter::threshold, truth);
  EXPECT_NEAR(moments(task.grid, posterior, Parameter::threshold).mean, threshold, 0.1);
  EXPECT_GT(posterior.log_mass[static_cast<std::size_t>(truth)], std::log(1e-3));
  for (const double log_mass : posterior.log_mass) ASSERT_TRUE(std::isfinite(log_mass));
  EXPECT_EQ(*std::min_element(posterior.mass.begin(), posterior.mass.end()), 0)
      << "points that underflow in the linear domain are what the logarithms are for";
}

TEST(QuestPlusPosterior, AWrittenOffPointComesBack) {
  const Task task = make_task(PlacementOutcome::correct);
  QuestPlusPosterior posterior = uniform_posterior(task.grid.points());
  const int finest = task.tables.stimuli - 1;
  for (int trial = 0; trial < 300; ++trial) learn(posterior, task.tables, finest, 1);  // sees it always
  const Moments seeing = moments(task.grid, posterior, Parameter::threshold);
  for (int trial = 0; trial < 3000; ++trial) learn(posterior, task.tables, 0, trial % 3 == 0);  // guesses
  for (int trial = 0; trial < 3000; ++trial) learn(posterior, task.tables, finest, trial % 3 == 0);
  const Moments guessing = moments(task.grid, posterior, Parameter::threshold);
  EXPECT_GT(seeing.mean, 12);
  EXPECT_LT(guessing.mean, 6);
  EXPECT_NEAR(total(posterior), 1, 1e-12);
}

/// Right where the seam is finest, wrong where it is coarsest, again and again.
TEST(QuestPlusPosterior, ContradictoryAnswersGiveAWidePosteriorAndNoNonsense) {
  for (const PlacementOutcome outcome : {PlacementOutcome::correct, PlacementOutcome::noticeability}) {
    const Task task = make_task(outcome);
    QuestPlusPosterior posterior = uniform_posterior(task.grid.points());
    const int best = task.tables.outcomes - 1, finest = task.tables.stimuli - 1;
    for (int trial = 0; trial < 500; ++trial) {
      learn(posterior, task.tables, finest, best);
      learn(posterior, task.tables, 0, 0);
      ASSERT_NEAR(total(posterior), 1, 1e-12);
      for (const double value : expected_entropies_nats(task.tables, posterior)) ASSERT_TRUE(value >= -1e-9);
    }
    for (const Parameter parameter : every_parameter) {
      const Moments belief = moments(task.grid, posterior, parameter);
      EXPECT_TRUE(std::isfinite(belief.mean) && std::isfinite(belief.sd));
      EXPECT_GE(belief.mean, task.grid.of(parameter).front() - 1e-9);
      EXPECT_LE(belief.mean, task.grid.of(parameter).back() + 1e-9);
    }
    // No falling function fits; the nearest are flat, with their threshold beyond the tested widths.
    EXPECT_FALSE(edge_alarms(task.grid, posterior, 0.1).empty());
  }
}

TEST(QuestPlusPosterior, AnAnswerThatEveryPointRulesOutTeachesNothing) {
  const QuestPlusTables tables =
      make_quest_plus_tables(2, 2, 4, [](int stimulus, int point) -> std::vector<double> {
        if (stimulus == 0) return {0, 1};  // nobody fails here
        return {0.2 * point, 1 - 0.2 * point};
      });
  QuestPlusPosterior posterior = uniform_posterior(4);
  learn(posterior, tables, 1, 0);
  const QuestPlusPosterior before = posterior;
  learn(posterior, tables, 0, 0);
  for (std::size_t point = 0; point < 4; ++point)
    EXPECT_NEAR(posterior.mass[point], before.mass[point], 1e-12);
  EXPECT_LT(posterior.mass[0], 1e-290) << "point 0 cannot fail at stimulus 1 either";
}

TEST(QuestPlusPosterior, TheOrderOfAnswersDoesNotMatter) {
  const Task task = make_task(PlacementOutcome::noticeability);
  std::vector<std::pair<int, int>> answers;
  Random random(5);
  for (int i = 0; i < 60; ++i)
    answers.emplace_back(static_cast<int>(random.below(task.width_px.size())),
                         static_cast<int>(random.below(5)));
  const auto posterior_of = [&] {
    QuestPlusPosterior posterior = uniform_posterior(task.grid.points());
    for (const auto& [stimulus, outcome] : answers) learn(posterior, task.tables, stimulus, outcome);
    return posterior;
  };
  const QuestPlusPosterior one = posterior_of();
  shuffle(std::span(answers), random);
  const QuestPlusPosterior other = posterior_of();
  for (std::size_t point = 0; point < one.mass.size(); ++point)
    ASSERT_NEAR(one.mass[point], other.mass[point], 1e-12);
}

}  // namespace
}  // namespace seamline::study
