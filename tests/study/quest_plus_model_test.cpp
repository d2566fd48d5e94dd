// Probabilities of outcomes, the grid, its marginals, intervals and alarms.
#include "study/placement/quest_plus_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "quest_plus_task.h"
#include "study/placement/psychometric_function.h"

namespace seamline::study {
namespace {

TEST(QuestPlusModel, BinaryOutcomeIsThePsychometricFunction) {
  const Task task = make_task(PlacementOutcome::correct);
  for (int point = 0; point < task.grid.points(); point += 7)
    for (const int width_px : task.width_px) {
      const std::vector<double> p = outcome_probabilities(task.definition, task.grid, point, width_px);
      ASSERT_EQ(p.size(), 2U);
      EXPECT_DOUBLE_EQ(p[0] + p[1], 1);
      const double z = (task.grid.value(Parameter::threshold, point) - std::log2(width_px)) /
                       task.grid.value(Parameter::scale, point);
      const double lapse = task.grid.value(Parameter::lapse, point);
      EXPECT_NEAR(p[1], 1.0 / 3 + (2.0 / 3 - lapse) / (1 + std::exp(-z)), 1e-12);
    }
}

TEST(QuestPlusModel, NoticeabilityRefinesTheBinaryOutcome) {
  for (const Sigmoid sigmoid : every_sigmoid) {
    Task task = make_task(PlacementOutcome::noticeability);
    task.definition.sigmoid = sigmoid;
    QuestPlusDefinition binary = task.definition;
    binary.outcome = PlacementOutcome::correct;
    for (int point = 0; point < task.grid.points(); point += 11)
      for (const int width_px : task.width_px) {
        const std::vector<double> p = outcome_probabilities(task.definition, task.grid, point, width_px);
        ASSERT_EQ(p.size(), 5U);
        for (const double value : p) ASSERT_TRUE(value >= 0 && value <= 1);
        EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1, 1e-12);
        EXPECT_NEAR(p[0], outcome_probabilities(binary, task.grid, point, width_px)[0], 1e-12);
      }
  }
}

TEST(QuestPlusModel, RatingsAreAsLikelyAsNotAtTheirOffsets) {
  Task task = make_task(PlacementOutcome::noticeability);
  task.definition.lapse = {0, 0, 1};
  task.grid = make_grid(task.definition);
  const int point = task.grid.points() / 2;
  const double threshold = task.grid.value(Parameter::threshold, point);
  const double step = task.grid.value(Parameter::rating_step, point);
  for (int rating = 2; rating <= 4; ++rating) {
    const std::vector<double> p =
        outcome_probabilities(task.definition, task.grid, point, std::exp2(threshold - (rating - 1) * step));
    EXPECT_NEAR(std::accumulate(p.begin() + rating, p.end(), 0.0), 0.5, 1e-12);
  }
}

TEST(QuestPlusModel, OutcomesOfAnswers) {
  QuestPlusDefinition definition;
  EXPECT_EQ(outcome_of(definition, {.chosen_index = 2, .rating = 3}, 2), 1);
  EXPECT_EQ(outcome_of(definition, {.chosen_index = 1, .rating = 3}, 2), 0);
  definition.outcome = PlacementOutcome::noticeability;
  EXPECT_EQ(outcome_of(definition, {.chosen_index = 2, .rating = 3}, 2), 3);
  EXPECT_EQ(outcome_of(definition, {.chosen_index = 1, .rating = 3}, 2), 0);
}

TEST(QuestPlusGrid, PointsAreAllCombinations) {
  const QuestPlusGrid grid{.values = {{{1, 2}, {3, 4, 5}, {0, 0.1}, {0.3}, {0.5, 1}}}};
  ASSERT_EQ(grid.points(), 24);
  std::set<std::vector<double>> seen;
  for (int point = 0; point < 24; ++point) {
    std::vector<double> values;
    for (const Parameter parameter : every_parameter) values.push_back(grid.value(parameter, point));
    seen.insert(values);
  }
  EXPECT_EQ(seen.size(), 24U);
}

TEST(QuestPlusGrid, StepsAreEqualRatiosOfWidths) {
  const QuestPlusGrid grid = make_grid(definition_for(seven_widths_px));
  const std::vector<double>& threshold = grid.of(Parameter::threshold);
  ASSERT_EQ(threshold.size(), 41U);
  EXPECT_DOUBLE_EQ(threshold.front(), 5);
  EXPECT_DOUBLE_EQ(threshold.back(), 13);
  EXPECT_NEAR(threshold[1] - threshold[0], 0.2, 1e-12);
  EXPECT_NEAR(grid.of(Parameter::scale)[4], 0.5, 1e-12);
  EXPECT_EQ(grid.of(Parameter::guess), std::vector<double>{1.0 / 3});
}

/// Each threshold of the grid in turn holds the mass.
QuestPlusPosterior gaussian(const QuestPlusGrid& grid, double mean, double sd) {
  QuestPlusPosterior posterior = uniform_posterior(grid.points());
  double sum = 0;
  for (int point = 0; point < grid.points(); ++point) {
    const double z = (grid.value(Parameter::threshold, point) - mean) / sd;
    sum += posterior.mass[static_cast<std::size_t>(point)] = std::exp(-z * z / 2);
  }
  for (double& mass : posterior.mass) mass /= sum;
  return posterior;
}

TEST(QuestPlusGrid, MomentsAndIntervalOfABell) {
  const QuestPlusGrid grid = make_grid(definition_for(seven_widths_px));
  const QuestPlusPosterior posterior = gaussian(grid, 8.7, 0.5);
  const Moments threshold = moments(grid, posterior, Parameter::threshold);
  EXPECT_NEAR(threshold.mean, 8.7, 1e-6);
  EXPECT_NEAR(threshold.sd, 0.5, 1e-4);
  const CredibleInterval interval = interval95(grid, posterior, Parameter::threshold);
  EXPECT_NEAR(interval.low, 8.7 - 1.96 * 0.5, 0.02);
  EXPECT_NEAR(interval.high, 8.7 + 1.96 * 0.5, 0.02);
}

TEST(QuestPlusGrid, AlarmsOnlyWhereThePosteriorLeansOnTheEdge) {
  const QuestPlusGrid grid = make_grid(definition_for(seven_widths_px));
  EXPECT_TRUE(edge_alarms(grid, uniform_posterior(grid.points()), 0.1).empty());
  EXPECT_TRUE(edge_alarms(grid, gaussian(grid, 9, 0.5), 0.1).empty());
  const std::vector<EdgeAlarm> high = edge_alarms(grid, gaussian(grid, 13.1, 0.5), 0.1);
  ASSERT_EQ(high.size(), 1U);
  EXPECT_TRUE(high[0].parameter == Parameter::threshold && high[0].highest && high[0].mass > 0.2);
  EXPECT_THAT(text(high[0]), testing::StartsWith("threshold at the grid's highest value (0."));
  const std::vector<EdgeAlarm> low = edge_alarms(grid, gaussian(grid, 4.9, 0.5), 0.1);
  ASSERT_EQ(low.size(), 1U);
  EXPECT_FALSE(low[0].highest);
}

TEST(QuestPlusGrid, NoLapsesIsNotAnEdge) {
  const Task task = make_task(PlacementOutcome::correct);
  QuestPlusPosterior posterior = uniform_posterior(task.grid.points());
  for (int trial = 0; trial < 400; ++trial) learn(posterior, task.tables, 0, 1);  // never lapses
  EXPECT_GT(marginal(task.grid, posterior, Parameter::lapse).front(), 0.5);
  for (const EdgeAlarm& alarm : edge_alarms(task.grid, posterior, 0.1))
    EXPECT_NE(alarm.parameter, Parameter::lapse);
}

/// A person whose threshold lies beyond the grid is noticed; one inside is not.
TEST(QuestPlusGrid, AnswersFromBeyondTheGridGiveTheAlarm) {
  const Task task = make_task(PlacementOutcome::correct);
  const auto leans = [&](int outcome, bool highest) {
    QuestPlusPosterior posterior = uniform_posterior(task.grid.points());
    for (int trial = 0; trial < 40; ++trial) learn(posterior, task.tables, task.best(posterior), outcome);
    for (const EdgeAlarm& alarm : edge_alarms(task.grid, posterior, 0.1))
      if (alarm.parameter == Parameter::threshold && alarm.highest == highest) return true;
    return false;
  };
  EXPECT_TRUE(leans(1, true)) << "always right";
  EXPECT_TRUE(leans(0, false)) << "always wrong";
}

}  // namespace
}  // namespace seamline::study
