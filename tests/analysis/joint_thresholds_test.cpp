// What is read off the joint model: places, intervals, contrasts, people, checks.
#include "analysis/joint/joint_thresholds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/joint/joint_contrasts.h"
#include "analysis/joint/joint_goodness.h"
#include "analysis/joint/joint_sharing.h"
#include "support/text/numbers.h"
#include "tests/analysis/joint_answers.h"

namespace seamline::analysis {
namespace {

struct Fitted {
  JointData data;
  JointFit fit;
  JointJackknife left_out;
};

Fitted fitted(const test::JointAnswers& people, std::uint64_t seed) {
  Fitted all{.data = test::draw_answers(people, seed), .fit = {}, .left_out = {}};
  all.fit = fit_joint(all.data);
  if (all.fit.estimated()) all.left_out = leave_people_out(all.fit, all.data);
  return all;
}

TEST(JointThresholds, GradientsAreThoseOfDifferences) {
  const JointFit fit = fitted({.people_sd = 0.5}, 3).fit;
  constexpr double h = 1e-5;
  for (const JointQuantity quantity : every_joint_quantity) {
    const std::optional<JointPlace> place = place_of(fit.model, fit.theta, 1, quantity);
    ASSERT_TRUE(place) << word(quantity);
    for (Eigen::Index i = 0; i < fit.theta.size(); ++i) {
      Eigen::VectorXd up = fit.theta, down = fit.theta;
      up[i] += h;
      down[i] -= h;
      const double difference =
          (place_of(fit.model, up, 1, quantity)->x - place_of(fit.model, down, 1, quantity)->x) / (2 * h);
      EXPECT_NEAR(place->gradient[i], difference, 1e-5) << word(quantity) << " " << i;
    }
  }
}

TEST(JointThresholds, MeansReachTheirLevelsAndIpIsSteepest) {
  const JointFit fit = fitted({.people_sd = 0.5}, 4).fit;
  for (const JointQuantity quantity : every_joint_quantity) {
    const JointPlace place = place_of(fit.model, fit.theta, 2, quantity).value();
    const std::optional<SoughtMean> sought = sought_mean(quantity);
    if (sought) {
      EXPECT_NEAR(mean_at_x(fit.model, fit.theta, 2, sought->mean, place.x).value, sought->level, 1e-10);
      continue;
    }
    const auto slope = [&](double x) {
      return mean_at_x(fit.model, fit.theta, 2, JointMean::as_counted, x).slope;
    };
    EXPECT_LT(slope(place.x), slope(place.x - 0.05));
    EXPECT_LT(slope(place.x), slope(place.x + 0.05));
  }
}

TEST(JointThresholds, MeanIsTheSumOverOutcomes) {
  const JointCurve curve = test::JointAnswers{}.shape;
  for (const double x : {-2.0, 0.0, 1.0, 4.0}) {
    const Eigen::VectorXd p = outcome_probabilities(curve, x, 0.3);
    EXPECT_NEAR(mean_noticeability(curve, JointMean::as_counted, 0.3, x),
                p[0] + 2 * p[1] + 3 * p[2] + 4 * p[3], 1e-14);
  }
}

TEST(JointThresholds, IntervalsEndWhereThePivotIsCritical) {
  const Fitted all = fitted({.people_sd = 0.5}, 5);
  const std::vector<JointThreshold> rows = joint_thresholds(all.fit, all.data, all.left_out);
  ASSERT_EQ(rows.size(), 24U);
  int closed = 0;
  for (const JointThreshold& row : rows) {
    const std::optional<SoughtMean> sought = sought_mean(row.quantity);
    if (!sought || !row.here.level_x) continue;
    ++closed;
    EXPECT_LT(row.here.ci95.low_x, *row.here.level_x);
    EXPECT_GT(row.here.ci95.high_x, *row.here.level_x);
    EXPECT_LE(row.simultaneous.low_x, row.here.ci95.low_x);
    EXPECT_GE(row.simultaneous.high_x, row.here.ci95.high_x);
    EXPECT_NEAR(level_pivot(all.fit, all.left_out, row.curve, *sought, row.here.ci95.low_x), 2.093, 2e-3);
    EXPECT_NEAR(level_pivot(all.fit, all.left_out, row.curve, *sought, row.here.ci95.high_x), -2.093, 2e-3);
  }
  EXPECT_GE(closed, 15);
}

TEST(JointThresholds, NoNumberOfPeopleTellsTheFormOfTheCurve) {
  Fitted all = fitted({.people_sd = 0.5}, 5);
  all.left_out.covariance.setZero();
  const auto length = [&](JointQuantity quantity) {
    const LevelInterval ci95 = joint_threshold(all.fit, all.data, all.left_out, 1, quantity).here.ci95;
    return ci95.high_x - ci95.low_x;
  };
  const double scale = std::exp(all.fit.theta[all.fit.model.log_scale(1)]);
  EXPECT_LT(length(JointQuantity::detection), 0.02) << "the form says little of the curve's middle";
  EXPECT_GT(length(JointQuantity::perceptual), length(JointQuantity::perceptual_corrected));
  EXPECT_GT(length(JointQuantity::perceptual), 0.03 * scale);
  EXPECT_LT(length(JointQuantity::perceptual), 0.5 * scale);
}

TEST(JointThresholds, ALevelInTheFloorOfGuessesHasNoNumber) {
  test::JointAnswers people;
  people.shape.g = {0.3, 0.4, 0.2, 0.1};  // floor 0.7
  const Fitted all = fitted(people, 6);
  for (const JointThreshold& row : joint_thresholds(all.fit, all.data, all.left_out)) {
    if (row.quantity != JointQuantity::perceptual) continue;
    EXPECT_FALSE(row.here.level_x);
    EXPECT_EQ(row.here.reason, NoThreshold::guess_floor);
  }
}

TEST(JointThresholds, LevelsFarApartCountAnErrorOfTheForm) {
  Fitted all = fitted({.people_sd = 0.5}, 4);
  EXPECT_EQ(place_error_of(all.fit, 2), 0.0);
  const auto length = [&] {
    const LevelInterval ci95 =
        joint_threshold(all.fit, all.data, all.left_out, 2, JointQuantity::detection).here.ci95;
    return ci95.high_x - ci95.low_x;
  };
  const double before = length();
  // The same fit, had only the levels on both sides of its slope been asked.
  const double m = curve_at(all.fit.model, all.fit.theta, 2).m,
               s = curve_at(all.fit.model, all.fit.theta, 2).s;
  for (JointCell& cell : all.fit.model.cells)
    if (cell.curve == 2 && std::abs(cell.x - m) < 3 * s) cell.x = m - 3 * s + (cell.x > m ? 6 * s : 0);
  EXPECT_NEAR(place_error_of(all.fit, 2), 0.15 * 2.5 * s, 1e-12);
  EXPECT_GT(length(), before);
}

TEST(JointThresholds, WithoutNumbersEachHasAReason) {
  test::JointAnswers people;
  people.m = {-100, -100, -100, -100};
  const Fitted all = fitted(people, 1);
  for (const JointThreshold& row : joint_thresholds(all.fit, all.data, all.left_out)) {
    EXPECT_FALSE(row.here.level_x);
    EXPECT_EQ(row.here.reason, NoThreshold::at_chance);
  }
}

std::vector<CurveLabel> four_artifacts() {
  return {{.artifact = "receiver", .condition = {}, .group = {}},
          {.artifact = "shadow", .condition = {}, .group = {}},
          {.artifact = "occlusion", .condition = {}, .group = {}},
          {.artifact = "overlap", .condition = {}, .group = {}}};
}

TEST(JointContrasts, AreDifferencesOfThresholdsInOctaves) {
  const Fitted all = fitted({.people_sd = 0.5}, 7);
  const JointContrasts contrasts = joint_contrasts(all.data, four_artifacts(), {}, {});
  ASSERT_EQ(contrasts.tables.size(), 2U);
  ASSERT_EQ(contrasts.tables[0].rows.size(), 6U);
  EXPECT_NEAR(contrasts.tables[0].rows[0].estimate, all.fit.theta[1] - all.fit.theta[0], 1e-9);
  EXPECT_EQ(contrasts.tables[0].rows[0].name, "shadow - receiver");
  for (const ContrastRow& row : contrasts.tables[0].rows) EXPECT_GE(row.adjusted_p, row.p - 1e-3);
}

TEST(JointContrasts, SlopesHaveFewerDegreesOfFreedomWhereFewPeopleCarryThem) {
  test::JointAnswers steep;
  steep.shape.s = 0.35;
  JointData data = test::draw_answers({}, 11);
  const Eigen::Index half = data.answers.cols() / 2;
  data.answers.rightCols(half) = test::draw_answers(steep, 12).answers.rightCols(half);
  const ContrastTable slopes = joint_contrasts(data, four_artifacts(), {}, {}).tables.at(1);
  EXPECT_LE(slopes.degrees_of_freedom, 19);
  EXPECT_GE(slopes.degrees_of_freedom, 2);
  int shown = 0;
  for (const ContrastRow& row : slopes.rows) shown += row.verdict == ContrastVerdict::differs ? 1 : 0;
  EXPECT_EQ(shown, 4) << "three times as steep is seen of 20 people; equal slopes are not";
  // What one person says alone is not shown: everybody else's answers at the second half are gone.
  data.answers.bottomRows(19).rightCols(half) =
      test::draw_answers({}, 11).answers.bottomRows(19).rightCols(half);
  EXPECT_LT(joint_contrasts(data, four_artifacts(), {}, {}).tables.at(1).degrees_of_freedom, 19);
}

TEST(JointContrasts, GroupsAreCurvesOfTheirOwn) {
  const JointData data = test::draw_answers({}, 8);
  std::vector<int> group(20, 0);
  for (std::size_t p = 0; p < 8; ++p) group[p] = 1;
  group[19] = -1;
  const JointData split = split_by_group(data, group, 2);
  EXPECT_EQ(split.people.size(), 19U);
  EXPECT_EQ(split.curves.size(), 8U);
  EXPECT_DOUBLE_EQ(split.answers.sum(), 19.0 * 84);
  EXPECT_DOUBLE_EQ(split.answers.row(0).tail(data.answers.cols()).sum(), 84);
  EXPECT_TRUE(fit_joint(split).estimated());
}

TEST(JointPeople, RanksPeopleAndShrinksThem) {
  test::JointAnswers people;
  people.people_sd = 0.8;
  people.shape.s = 0.5;
  const Fitted all = fitted(people, 9);
  const JointPeople found = joint_people(all.fit, all.data);
  EXPECT_GT(found.shift_sd, 0.5);
  EXPECT_LT(found.shift_sd, 1.2);
  ASSERT_EQ(found.thresholds.size(), 80U);
  Random random(9);
  Eigen::ArrayXd shift(20), away(20);
  int held = 0;
  // The same draws as the answers': a person's shift comes first.
  for (Eigen::Index p = 0; p < 20; ++p) {
    shift[p] = 0.8 * random.normal();
    for (int draw = 0; draw < 84; ++draw) random.uniform();
    const PersonThreshold& row = found.thresholds[static_cast<std::size_t>(4 * p)];
    const double planted = people.m[0] + shift[p];
    away[p] = 0;
    for (Eigen::Index c = 0; c < 4; ++c)
      away[p] += (found.thresholds[static_cast<std::size_t>(4 * p + c)].x - all.fit.theta[c]) / 4;
    held += row.ci95.low_x <= planted && planted <= row.ci95.high_x ? 1 : 0;
  }
  shift -= shift.mean();
  away -= away.mean();
  EXPECT_GT((shift * away).sum() / std::sqrt(shift.square().sum() * away.square().sum()), 0.9);
  EXPECT_GE(held, 14);
}

/// Over a thousand people shifts come from a table and their spread from a thousand of them.
TEST(JointPeople, ManyDifferAsTheyWereDrawnAndTheirAnswersAreTheModels) {
  const Fitted all = fitted({.m = {8.2, 9.8}, .levels = {6, 8, 10, 12}, .people_sd = 0.5, .people = 1100}, 9);
  const JointPeople people = joint_people(all.fit, all.data);
  EXPECT_NEAR(people.shift_sd, 0.5, 0.1);
  ASSERT_EQ(people.thresholds.size(), 2200U);
  for (const PersonThreshold& row : people.thresholds)
    EXPECT_NEAR(row.x, all.fit.theta[row.curve], 6 * people.shift_sd);
  const JointGoodness found =
      joint_goodness(all.fit, all.data, people, {.replicates = 40, .seed = 1, .threads = 2});
  EXPECT_GT(found.choices_p, 0.03);
  EXPECT_GT(found.ratings_p, 0.03);
}

TEST(JointGoodness, AcceptsTheModelsOwnAnswersAndCountsThemAll) {
  const Fitted all = fitted({.people_sd = 0.5}, 10);
  const JointPeople people = joint_people(all.fit, all.data);
  const JointGoodness one =
      joint_goodness(all.fit, all.data, people, {.replicates = 40, .seed = 1, .threads = 1});
  const JointGoodness two =
      joint_goodness(all.fit, all.data, people, {.replicates = 40, .seed = 1, .threads = 2});
  EXPECT_EQ(one.choices_p, two.choices_p);
  EXPECT_EQ(one.ratings_p, two.ratings_p);
  EXPECT_GT(one.choices_p, 0.03);
  EXPECT_GT(one.ratings_p, 0.03);
  double observed = 0, expected = 0;
  for (const ScoreCell& cell : one.cells) {
    observed += cell.observed;
    expected += cell.expected;
  }
  EXPECT_DOUBLE_EQ(observed, 20.0 * 84);
  EXPECT_NEAR(expected, 20.0 * 84, 1e-9);
}

TEST(JointGoodness, SeesACurveThatRisesAgain) {
  Fitted all = fitted({.people_sd = 0.3}, 12);
  // At the hardest level of a curve everybody sees.
  const Eigen::Index last = 6 * all.data.cell_counts();
  all.data.answers.middleCols(last, all.data.cell_counts()).setZero();
  all.data.answers.col(last).setConstant(3);
  all.fit = fit_joint(all.data);
  const JointGoodness found = joint_goodness(all.fit, all.data, joint_people(all.fit, all.data),
                                             {.replicates = 40, .seed = 1, .threads = 2});
  EXPECT_LT(found.choices_p, 0.05);
}

TEST(JointSharing, IsRefusedWhereScalesDiffer) {
  test::JointAnswers people;
  people.people = 40;
  const Fitted same = fitted({.people_sd = 0.4, .people = 40}, 13);
  const std::vector<SharingTest> tests = test_sharing(same.fit, same.data);
  ASSERT_EQ(tests.size(), 5U);
  EXPECT_EQ(tests[0].parameters, 2);
  EXPECT_EQ(tests[1].parameters, 3);
  EXPECT_EQ(tests[2].parameters, 12);
  for (const SharingTest& one : tests) EXPECT_GT(one.p, 0.001) << one.shared;
  // Two curves steep, two flat.
  JointData mixed = test::draw_answers(people, 14);
  people.shape.s = 0.35;
  const JointData steep = test::draw_answers(people, 15);
  const Eigen::Index half = mixed.answers.cols() / 2;
  mixed.answers.leftCols(half) = steep.answers.leftCols(half);
  EXPECT_LT(test_sharing(fit_joint(mixed), mixed)[1].p, 0.001);
  // Where the answers decide, the refused block is each curve's own; where they do not, it stays shared.
  const SharedFit decided = fit_shared(mixed, {}, true), asked = fit_shared(mixed, {}, false);
  EXPECT_FALSE(decided.fit.model.sharing.scale);
  ASSERT_FALSE(decided.refused.empty());
  EXPECT_EQ(decided.refused[0].shared, "scale");
  EXPECT_GT(decided.fit.log_likelihood, asked.fit.log_likelihood);
  EXPECT_EQ(asked.fit.model.sharing, JointSharing{});
  EXPECT_EQ(asked.refused.size(), 0U);
  const SharedFit alike = fit_shared(same.data, {}, true);
  EXPECT_EQ(alike.fit.theta, same.fit.theta) << "nothing is refused of curves that are alike";
}

TEST(JointSharing, SeesARatingThatDoesNotDependOnTheLevel) {
  JointData data = test::draw_answers({.people_sd = 0.4, .people = 40}, 16);
  EXPECT_GT(test_sharing(fit_joint(data), data)[0].p, 0.001);
  // Half of all right answers are rated 4 at every level: the curve of 4 is flatter than that of 2.
  for (Eigen::Index c = 0; c < static_cast<Eigen::Index>(data.cells.size()); ++c) {
    const Eigen::Index first = c * data.cell_counts();
    const Eigen::MatrixXd lower = data.answers.middleCols(first, 3) / 2;
    data.answers.middleCols(first, 3) -= lower;
    data.answers.col(first + 3) += lower.rowwise().sum();
  }
  EXPECT_LT(test_sharing(fit_joint(data), data)[0].p, 0.01);
}

}  // namespace
}  // namespace seamline::analysis
