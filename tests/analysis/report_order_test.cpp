// Order of trials and residuals: the trend is that of least squares with people and stimuli fixed, and a
// sentence says something only where its interval excludes 0.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/QR>

#include "analysis/log_analysis/report_numbers.h"
#include "analysis/statistics/fixed_effects.h"
#include "tests/analysis/report_people.h"

namespace seamline::analysis {
namespace {

using namespace study;
using ::testing::HasSubstr;

/// Answers of everybody in an order of their own; the score of a right choice moves with the place.
LogContents log_with_trend(int people, double change, std::uint64_t seed) {
  LogContents log = test::people_log(people, seed);
  Random random(seed, 77);
  std::map<std::string, std::vector<Answer*>> of_person;
  for (Answer& answer : log.answers) of_person[answer.participant].push_back(&answer);
  for (auto& [code, answers] : of_person) {
    shuffle(std::span<Answer*>(answers), random);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      answers[i]->trial_index = static_cast<int>(i);
      const double place = static_cast<double>(i) / static_cast<double>(answers.size() - 1);
      const double move = std::abs(change) * place;
      const int whole = static_cast<int>(move) + (random.uniform() < move - std::floor(move) ? 1 : 0);
      answers[i]->rating = std::clamp(answers[i]->rating + (change > 0 ? whole : -whole), 1, 4);
    }
  }
  return log;
}

SessionOrder order_of(LogContents log) {
  return session_order(analyze(std::move(log), false, {.replicates = 100, .seed = 1}));
}

TEST(SessionOrder, TheTrendIsThatOfDummyVariables) {
  Random random(5, 1);
  TwoWayData data{.people = 7, .stimuli = 5};
  std::vector<double> y, x;
  for (int person = 0; person < data.people; ++person)
    for (int stimulus = 0; stimulus < data.stimuli; ++stimulus) {
      if (random.below(4) == 0) continue;  // unbalanced
      data.person.push_back(person);
      data.stimulus.push_back(stimulus);
      x.push_back(random.uniform());
      y.push_back(0.3 * person - stimulus + 2 * x.back() + random.normal());
    }
  const auto n = static_cast<Eigen::Index>(y.size());
  data.y = Eigen::Map<Eigen::VectorXd>(y.data(), n);
  data.x = Eigen::Map<Eigen::MatrixXd>(x.data(), n, 1);
  Eigen::MatrixXd dummies = Eigen::MatrixXd::Zero(n, 1 + data.people + data.stimuli);
  for (Eigen::Index i = 0; i < n; ++i) {
    dummies(i, 0) = data.x(i, 0);
    dummies(i, 1 + data.person[static_cast<std::size_t>(i)]) = 1;
    dummies(i, 1 + data.people + data.stimulus[static_cast<std::size_t>(i)]) = 1;
  }
  const Eigen::VectorXd by_dummies = dummies.completeOrthogonalDecomposition().solve(data.y);
  const TwoWayFit fit = fit_two_way(data);
  ASSERT_TRUE(fit.determined);
  EXPECT_NEAR(fit.b[0], by_dummies[0], 1e-8);
}

TEST(SessionOrder, SaysSomethingOnlyWhereTheIntervalExcludesZero) {
  const SessionOrder rising = order_of(log_with_trend(16, 1.5, 3));
  EXPECT_GT(rising.trend_ci95.low, 0);
  EXPECT_THAT(trend_sentence(rising), HasSubstr("Scores rise during the session"));
  EXPECT_GT(rising.thirds[2].mean, rising.thirds[0].mean);
  const SessionOrder falling = order_of(log_with_trend(16, -1.5, 3));
  EXPECT_LT(falling.trend_ci95.high, 0);
  EXPECT_THAT(trend_sentence(falling), HasSubstr("Scores fall during the session"));
  const SessionOrder none = order_of(log_with_trend(16, 0, 4));
  EXPECT_EQ(none.trend_ci95.low > 0 || none.trend_ci95.high < 0,
            trend_sentence(none).find("No trend") == std::string::npos);
}

TEST(SessionOrder, PartsAverageToTheMeanOfAllAnswers) {
  const SessionOrder order = order_of(log_with_trend(9, 1, 5));
  for (const auto* parts : {&order.thirds, &order.tenths}) {
    double sum = 0, answers = 0;
    for (const SessionPart& part : *parts) {
      sum += part.mean * part.answers;
      answers += part.answers;
    }
    double all = 0;
    const LogContents log = log_with_trend(9, 1, 5);
    for (const Answer& answer : log.answers) all += answer.noticeability();
    EXPECT_NEAR(sum / answers, all / static_cast<double>(log.answers.size()), 1e-9);
  }
}

TEST(SessionOrder, OneOrderForEverybodyTellsNothing) {
  const SessionOrder order = order_of(test::people_log(8, 4));
  bool same = true;
  const LogContents log = test::people_log(8, 4);
  for (std::size_t i = 0; i < 84; ++i)
    same = same && log.answers[i].stimulus_id == log.answers[84 + i].stimulus_id;
  EXPECT_EQ(same, !order.missing.empty());
  EXPECT_EQ(order.people_residuals.size(), 8U);
  double sum = 0;
  for (const MeanResidual& one : order.people_residuals) sum += one.mean;
  EXPECT_NEAR(sum, 0, 1e-9);  // less the mean of everybody
}

}  // namespace
}  // namespace seamline::analysis
