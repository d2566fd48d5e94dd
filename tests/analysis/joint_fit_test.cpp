// Laws of the joint model's likelihood, maximum and verdicts.
#include "analysis/joint/joint_fit.h"

#include <gtest/gtest.h>

#include "analysis/joint/joint_jackknife.h"
#include "support/text/error.h"
#include "support/text/numbers.h"
#include "tests/analysis/joint_answers.h"

namespace seamline::analysis {
namespace {

JointSharing sharing_number(int number) {
  return {.scale = (number & 1) != 0,
          .criteria = (number & 2) != 0,
          .lapse = (number & 4) != 0,
          .guess_ratings = (number & 8) != 0};
}

/// A place away from any maximum.
Eigen::VectorXd some_theta(const JointModel& model, std::uint64_t seed) {
  Random random(seed);
  Eigen::VectorXd theta = penalty_centre(model);
  for (Eigen::Index i = 0; i < theta.size(); ++i) theta[i] += 2 * random.uniform() - 1;
  return theta;
}

double relative(double a, double b) {
  return std::abs(a - b) / (1 + std::abs(b));
}

TEST(JointFit, DerivativesAreThoseOfDifferences) {
  constexpr double h = 1e-5;
  for (int ratings = 1; ratings <= 4; ++ratings)
    for (const int number : {0, 5, 10, 15}) {
      test::JointAnswers people;
      people.shape.ratings = ratings;
      people.shape.g = ratings == 1 ? std::array<double, 4>{1, 0, 0, 0} : people.shape.g;
      JointData data = test::draw_answers(people, 3);
      data.references.setOnes();
      data.cells.back().x = infinity;  // nothing to see
      const JointModel model = joint_model(data, sharing_number(number));
      const JointCounts counts = all_counts(data);
      const Eigen::VectorXd theta = some_theta(model, 7);
      const Evaluation at = joint_objective(model, counts, theta);
      for (Eigen::Index i = 0; i < theta.size(); ++i) {
        Eigen::VectorXd up = theta, down = theta;
        up[i] += h;
        down[i] -= h;
        const auto value = [&](const Eigen::VectorXd& place) {
          return joint_log_likelihood(model, counts, place) + joint_penalty(model, place).value;
        };
        EXPECT_LT(relative((value(up) - value(down)) / (2 * h), at.gradient[i]), 1e-6) << ratings << " " << i;
        const Eigen::VectorXd column =
            (joint_objective(model, counts, up).gradient - joint_objective(model, counts, down).gradient) /
            (2 * h);
        for (Eigen::Index j = 0; j < theta.size(); ++j)
          EXPECT_LT(relative(column[j], at.hessian(j, i)), 1e-6) << ratings << " " << i << " " << j;
      }
    }
}

TEST(JointFit, ProbabilitiesSumToOne) {
  const JointCurve curve = test::JointAnswers{}.shape;
  for (const double x : {-30.0, -1.0, 0.0, 0.7, 3.0, 40.0, infinity})
    EXPECT_NEAR(outcome_probabilities(curve, x, 0.25).sum(), 1, 1e-15);
}

TEST(JointFit, FindsWhatWasPlantedInExpectedAnswers) {
  test::JointAnswers people;
  people.people = 4000;  // the penalties are worth less than an answer
  const JointFit fit = fit_joint(test::expected_answers(people));
  ASSERT_TRUE(fit.estimated()) << fit.explanation;
  for (int c = 0; c < 4; ++c) {
    const JointCurve curve = curve_at(fit.model, fit.theta, c);
    EXPECT_NEAR(curve.m, people.m[static_cast<std::size_t>(c)], 2e-3);
    EXPECT_NEAR(curve.s, people.shape.s, 2e-3);
    EXPECT_NEAR(curve.lapse, people.shape.lapse, 1e-3);
    EXPECT_NEAR(curve.rho, people.shape.rho, 5e-3);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(curve.t[k], people.shape.t[k], 5e-3);
    for (std::size_t r = 0; r < 4; ++r) EXPECT_NEAR(curve.g[r], people.shape.g[r], 1e-3);
  }
}

TEST(JointFit, TheMaximumIsStationaryAndHigherThanThePlantedPlace) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const JointFit fit = fit_joint(test::draw_answers({.people_sd = 0.7}, seed));
    ASSERT_TRUE(fit.estimated()) << fit.explanation;
    const JointData data = test::draw_answers({.people_sd = 0.7}, seed);
    EXPECT_LT(joint_objective(fit.model, all_counts(data), fit.theta).gradient.cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_GE(fit.penalised,
              joint_log_likelihood(fit.model, all_counts(data), penalty_centre(fit.model)) - 1e-9);
  }
}

TEST(JointFit, MovesWithTheAxisAndDoesNotAskForNames) {
  const JointData data = test::draw_answers({.people_sd = 0.5}, 5);
  JointData moved = data;
  for (JointCell& cell : moved.cells) cell.x = 2 * cell.x - 3;
  JointData reordered =
      of_people(data, {19, 3, 7, 0, 1, 2, 4, 5, 6, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18});
  const JointFit fit = fit_joint(data), of_moved = fit_joint(moved), of_reordered = fit_joint(reordered);
  for (int c = 0; c < 4; ++c) {
    const JointCurve curve = curve_at(fit.model, fit.theta, c),
                     there = curve_at(of_moved.model, of_moved.theta, c);
    EXPECT_NEAR(there.m, 2 * curve.m - 3, 1e-6);
    EXPECT_NEAR(there.s, 2 * curve.s, 1e-6);
    EXPECT_NEAR(curve_at(of_reordered.model, of_reordered.theta, c).m, curve.m, 1e-9);
  }
  EXPECT_NEAR(of_moved.log_likelihood, fit.log_likelihood, 1e-6);
}

TEST(JointFit, AMillionAnswersCountAsTheirTable) {
  JointData data = test::draw_answers({.people_sd = 0.5}, 6);
  const JointFit few = fit_joint(data);
  data.answers *= 600;
  ASSERT_GT(data.answers.sum(), 1e6);
  const JointFit many = fit_joint(data);
  ASSERT_TRUE(many.estimated());
  for (int c = 0; c < 4; ++c)
    EXPECT_NEAR(many.theta[many.model.threshold(c)], few.theta[few.model.threshold(c)], 0.05);
}

TEST(JointFit, ScoresOfPeopleSumToTheGradient) {
  JointData data = test::draw_answers({.people_sd = 0.5}, 8);
  const JointModel model = joint_model(data, sharing_number(6));
  const Eigen::VectorXd theta = some_theta(model, 9);
  const Eigen::VectorXd by_outcome = outcome_scores(model, theta) * all_counts(data).cells;
  EXPECT_LT((by_outcome - joint_likelihood(model, all_counts(data), theta).gradient).norm(), 1e-8);
}

TEST(JointFit, ScoresOfEachPersonAreTheGradientOfTheirLikelihood) {
  JointData data = test::draw_answers({.people_sd = 0.5, .people = 3}, 8);
  data.references.row(1) << 4, 2, 1, 1;
  const JointModel model = joint_model(data, sharing_number(6));
  const Eigen::VectorXd theta = some_theta(model, 9);
  const Eigen::MatrixXd scores = person_scores(model, data, theta);
  for (Eigen::Index p = 0; p < 3; ++p)
    EXPECT_LT((scores.row(p).transpose() - joint_likelihood(model, person_counts(data, p), theta).gradient)
                  .cwiseAbs()
                  .maxCoeff(),
              1e-9);
}

/// Of more people than are climbed for, one step each; twenty people counted eleven times over.
TEST(JointFit, ManyPeopleVaryAsFewDo) {
  const JointData few = test::draw_answers({.people_sd = 0.5}, 11);
  std::vector<Eigen::Index> rows;
  for (Eigen::Index p = 0; p < 220; ++p) rows.push_back(p % 20);
  const JointData many = of_people(few, rows);
  const JointFit fit = fit_joint(many);
  const Eigen::MatrixXd of_few = leave_people_out(fit_joint(few), few).covariance,
                        of_many = leave_people_out(fit, many).covariance;
  for (Eigen::Index c = 0; c < 4; ++c) EXPECT_NEAR(of_many(c, c) * 220 / (of_few(c, c) * 20), 0.95, 0.15);
}

TEST(JointFit, LeavingAPersonOutIsNearlyFittingWithoutThem) {
  const JointData data = test::draw_answers({.people_sd = 0.5}, 11);
  const JointFit fit = fit_joint(data);
  const JointJackknife left = leave_people_out(fit, data);
  std::vector<Eigen::Index> others;
  for (Eigen::Index p = 1; p < 20; ++p) others.push_back(p);
  const JointFit without = fit_joint(of_people(data, others));
  for (Eigen::Index c = 0; c < 4; ++c) {
    const double moved = without.theta[c] - fit.theta[c];
    EXPECT_NEAR(left.theta(0, c) - fit.theta[c], moved, 0.1 * std::abs(moved) + 2e-3);
  }
}

// Verdicts: no number that means nothing.

TEST(JointVerdicts, OfAnswersThatSayNothing) {
  test::JointAnswers people;
  EXPECT_EQ(fit_joint(test::empty_answers(people)).verdict, NoThreshold::no_answers);

  people.people = 1;
  EXPECT_EQ(fit_joint(test::draw_answers(people, 1)).verdict, NoThreshold::one_participant);

  people.people = 20;
  people.levels = {7, 10};
  EXPECT_EQ(fit_joint(test::draw_answers(people, 1)).verdict, NoThreshold::too_few_levels);

  people = {};
  people.m = {-100, -100, -100, -100};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const JointFit guessers = fit_joint(test::draw_answers(people, seed));
    EXPECT_EQ(guessers.verdict, NoThreshold::only_guesses) << verdict_text(guessers.verdict);
    EXPECT_EQ(guessers.theta.size(), 0);
  }

  people = {};
  people.m = {100, 100, 100, 100};
  people.shape.lapse = 0;
  EXPECT_EQ(fit_joint(test::draw_answers(people, 1)).verdict, NoThreshold::never_wrong);
}

TEST(JointVerdicts, AStepIsSeparated) {
  test::JointAnswers people;
  people.shape.s = 1e-3;
  people.shape.lapse = 0;
  people.m = {8.5, 7.5, 9.5, 9.5};
  const JointFit fit = fit_joint(test::draw_answers(people, 1));
  EXPECT_EQ(fit.verdict, NoThreshold::separated) << verdict_text(fit.verdict);
  EXPECT_FALSE(fit.explanation.empty());
}

TEST(JointVerdicts, ACurveWithoutAnswersLeavesTheOthersTheirs) {
  test::JointAnswers people;
  JointData data = test::draw_answers(people, 2);
  const Eigen::Index width = data.cell_counts() * 7;
  data.answers.middleCols(width, width).setZero();
  // Empty cells in another curve.
  data.answers.middleCols(2 * width, 2 * data.cell_counts()).setZero();
  const JointFit fit = fit_joint(data);
  ASSERT_TRUE(fit.estimated());
  EXPECT_EQ(fit.curves[1], NoThreshold::no_answers);
  EXPECT_EQ(fit.curves[0], std::nullopt);
  EXPECT_EQ(fit.curves[2], std::nullopt);
}

TEST(JointVerdicts, BadTablesAreRefusedByName) {
  JointData data = test::draw_answers({}, 1);
  data.answers(3, 5) = -1;
  EXPECT_THROW(static_cast<void>(fit_joint(data)), InputError);
  data = test::draw_answers({}, 1);
  data.cells[2].chance = 1;
  EXPECT_THROW(static_cast<void>(fit_joint(data)), InputError);
  data = test::draw_answers({}, 1);
  data.references.conservativeResize(3, 4);
  EXPECT_THROW(static_cast<void>(fit_joint(data)), InputError);
}

}  // namespace
}  // namespace seamline::analysis
