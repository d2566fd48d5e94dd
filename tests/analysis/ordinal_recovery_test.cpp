// Planted parameters come back, and the same bits for any number of threads.
#include <gtest/gtest.h>

#include "analysis/ordinal/likelihood/mixed_fit.h"
#include "tests/analysis/ordinal_people.h"

namespace seamline::analysis {
namespace {

using test::OrdinalPopulation;
using test::simulate_scores;

/// Over many studies estimates scatter around what was planted as their standard errors say.
void expect_recovery(const OrdinalPopulation& population, int nodes) {
  constexpr int studies = 40;
  const Eigen::Vector3d planted(population.slope, population.object2, population.object3);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), z_squared = Eigen::Vector3d::Zero(),
                  variance = Eigen::Vector3d::Zero();
  double sd_sum = 0, first_cut_sum = 0;
  for (int study = 0; study < studies; ++study) {
    const OrdinalFit fit =
        fit_cumulative_link_mixed(simulate_scores(population, 30, 100 + static_cast<std::uint64_t>(study)),
                                  {.link = population.link, .nodes = nodes});
    ASSERT_TRUE(has_estimates(fit.verdict)) << fit.explanation;
    for (Eigen::Index j = 0; j < 3; ++j) {
      const double error = fit.coefficients[j] - planted[j];
      const double its_variance = fit.covariance(4 + j, 4 + j);
      sum[j] += error;
      variance[j] += its_variance;
      z_squared[j] += error * error / its_variance;
    }
    sd_sum += fit.participant_sd;
    first_cut_sum += fit.cuts[0];
  }
  for (Eigen::Index j = 0; j < 3; ++j) {
    EXPECT_LT(std::abs(sum[j]), 3.5 * std::sqrt(variance[j])) << j;
    EXPECT_NEAR(z_squared[j] / studies, 1, 3.5 * std::sqrt(2.0 / studies)) << j;
  }
  EXPECT_NEAR(sd_sum / studies, population.sd, 0.08 * population.sd);  // maximum likelihood is a little low
  EXPECT_NEAR(first_cut_sum / studies, population.cuts[0], 0.12);
}

TEST(OrdinalRecovery, Logit) {
  expect_recovery({}, 9);
}

TEST(OrdinalRecovery, LogitByLaplace) {
  expect_recovery({}, 1);
}

TEST(OrdinalRecovery, Probit) {
  expect_recovery({.link = Link::probit,
                   .cuts = {-1.2, -0.3, 0.4, 1.2},
                   .slope = -0.65,
                   .object2 = 0.2,
                   .object3 = -0.2,
                   .sd = 0.5},
                  9);
}

TEST(OrdinalRecovery, TenThousandParticipants) {
  const OrdinalPopulation population;
  const OrdinalFit fit = fit_cumulative_link_mixed(simulate_scores(population, 10000, 9, 1), {.nodes = 9});
  ASSERT_EQ(fit.verdict, OrdinalVerdict::estimated) << fit.explanation;
  EXPECT_EQ(fit.participants, 10000);
  const auto within = [&](double estimate, double planted, Eigen::Index at) {
    EXPECT_LT(std::abs(estimate - planted), 3.5 * std::sqrt(fit.covariance(at, at))) << at;
    EXPECT_LT(std::sqrt(fit.covariance(at, at)), 0.04);
  };
  for (Eigen::Index c = 0; c < 4; ++c) within(fit.cuts[c], population.cuts[static_cast<std::size_t>(c)], c);
  within(fit.coefficients[0], population.slope, 4);
  within(fit.participant_sd, population.sd, 5);
  // Under the true model both kinds of standard error estimate the same thing.
  for (Eigen::Index k = 0; k < 5; ++k)
    EXPECT_NEAR(std::sqrt(fit.robust_covariance(k, k) / fit.covariance(k, k)), 1, 0.05);
}

TEST(OrdinalRecovery, OrderOfRowsAndThreadsDoNotMatter) {
  const OrdinalData data = simulate_scores({}, 70, 12);
  const OrdinalFit one = fit_cumulative_link_mixed(data, {.nodes = 7, .threads = 1});
  const OrdinalFit fixed_one = fit_cumulative_link(data, {.threads = 1});
  for (const int threads : {2, 3, 8}) {
    const OrdinalFit many = fit_cumulative_link_mixed(data, {.nodes = 7, .threads = threads});
    EXPECT_EQ(many.coefficients, one.coefficients);
    EXPECT_EQ(many.cuts, one.cuts);
    EXPECT_EQ(many.covariance, one.covariance);
    EXPECT_EQ(many.robust_covariance, one.robust_covariance);
    EXPECT_EQ(many.log_likelihood, one.log_likelihood);
    EXPECT_EQ(many.participant_effect, one.participant_effect);
    const OrdinalFit fixed_many = fit_cumulative_link(data, {.threads = threads});
    EXPECT_EQ(fixed_many.coefficients, fixed_one.coefficients);
    EXPECT_EQ(fixed_many.covariance, fixed_one.covariance);
  }
  OrdinalData mixed_up = data;
  const std::size_t rows = data.score.size();
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t from = (i * 997) % rows;  // 997 is prime and no divisor of 1470
    mixed_up.score[i] = data.score[from];
    mixed_up.participant[i] = data.participant[from];
    mixed_up.predictors.row(static_cast<Eigen::Index>(i)) =
        data.predictors.row(static_cast<Eigen::Index>(from));
  }
  const OrdinalFit again = fit_cumulative_link_mixed(mixed_up, {.nodes = 7});
  EXPECT_LT((again.coefficients - one.coefficients).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(again.log_likelihood, one.log_likelihood, 1e-9);
}

}  // namespace
}  // namespace seamline::analysis
