#include "analysis/scores/opinion_score.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/arithmetic/random.h"
#include "support/text/numbers.h"

namespace seamline::analysis {
namespace {

TEST(OpinionScore, ByHand) {
  Eigen::MatrixXd score(4, 1);
  score << 1, 2, 3, 4;
  const OpinionScore mos = opinion_scores(score).at(0);
  EXPECT_EQ(mos.n, 4);
  EXPECT_DOUBLE_EQ(mos.mean, 2.5);
  EXPECT_DOUBLE_EQ(mos.sd, std::sqrt(5.0 / 3));
  EXPECT_NEAR(mos.ci95_high - mos.mean, 3.182446305 * std::sqrt(5.0 / 3) / 2, 1e-8);  // t with 3 degrees
  EXPECT_NEAR(mos.mean - mos.ci95_low, mos.ci95_high - mos.mean, 1e-12);
}

TEST(OpinionScore, OfFewScoresSaysSo) {
  Eigen::MatrixXd score(2, 2);
  score << 1, nan, nan, nan;
  const std::vector<OpinionScore> mos = opinion_scores(score);
  EXPECT_EQ(mos[0].n, 1);
  EXPECT_DOUBLE_EQ(mos[0].mean, 1);
  EXPECT_TRUE(std::isnan(mos[0].ci95_low));
  EXPECT_EQ(mos[1].n, 0);
  EXPECT_TRUE(std::isnan(mos[1].mean));
}

/// Scores 4 Binomial(m, p) / m of people at stimuli of all difficulties: S^2 is x (4 - x) / m, so a is 1 / m.
Eigen::MatrixXd coin_scores(int people, int coins, Random& random) {
  Eigen::MatrixXd score(people, 40);
  for (Eigen::Index s = 0; s < score.cols(); ++s)
    for (Eigen::Index p = 0; p < score.rows(); ++p)
      score(p, s) = 4.0 * random.binomial(coins, (static_cast<double>(s) + 1) / 41) / coins;
  return score;
}

TEST(SosParameter, IsTheInverseOfTheNumberOfCoins) {
  Random random(1);
  for (int coins : {1, 2, 4, 10}) {
    const SosParameter sos = sos_parameter(coin_scores(400, coins, random), {.lowest = 0, .highest = 4});
    EXPECT_NEAR(sos.a, 1.0 / coins, 0.04 / coins);
    EXPECT_EQ(sos.stimuli, 40);
  }
}

TEST(SosParameter, IntervalHoldsThePlantedValue) {
  Random random(2);
  int held = 0;
  for (int study = 0; study < 200; ++study) {
    const SosParameter sos = sos_parameter(coin_scores(20, 4, random), {});
    held += sos.ci95_low <= 0.25 && 0.25 <= sos.ci95_high ? 1 : 0;
  }
  EXPECT_GE(held, 180);
}

TEST(SosParameter, OfPeopleWhoAgreeIsZero) {
  Eigen::MatrixXd score(5, 3);
  score.col(0).setConstant(1);
  score.col(1).setConstant(2);
  score.col(2).setConstant(3);
  EXPECT_DOUBLE_EQ(sos_parameter(score, {}).a, 0);
  EXPECT_TRUE(std::isnan(sos_parameter(Eigen::MatrixXd::Zero(5, 3), {}).a));  // all at an end: not defined
}

}  // namespace
}  // namespace seamline::analysis
