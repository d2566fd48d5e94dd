// Data that cannot be fitted, or only in part: each has a verdict, and none has a confident number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/ordinal/likelihood/mixed_fit.h"
#include "support/text/error.h"
#include "support/text/numbers.h"
#include "tests/analysis/ordinal_people.h"
#include "tests/complaint.h"

namespace seamline::analysis {
namespace {

using test::simulate_scores;
using ::testing::HasSubstr;

void expect_no_numbers(const OrdinalFit& fit, OrdinalVerdict verdict, const std::string& said) {
  EXPECT_EQ(word(fit.verdict), word(verdict)) << fit.explanation;
  EXPECT_THAT(fit.explanation, HasSubstr(said));
  EXPECT_EQ(fit.cuts.size(), 0);
  EXPECT_EQ(fit.coefficients.size(), 0);
  EXPECT_EQ(fit.covariance.size(), 0);
  EXPECT_EQ(fit.robust_covariance.size(), 0);
  EXPECT_TRUE(std::isnan(fit.log_likelihood));
  EXPECT_TRUE(std::isnan(fit.participant_sd));
  EXPECT_FALSE(fit.participant_sd_ci95().has_value());
}

/// Both models, both links.
void expect_everywhere(const OrdinalData& data, OrdinalVerdict verdict, const std::string& said) {
  for (const Link link : {Link::logit, Link::probit}) {
    expect_no_numbers(fit_cumulative_link(data, {.link = link}), verdict, said);
    expect_no_numbers(fit_cumulative_link_mixed(data, {.link = link}), verdict, said);
  }
}

TEST(OrdinalVerdicts, ConstantScores) {
  OrdinalData data = simulate_scores({}, 20, 1);
  data.score.assign(data.score.size(), 4);
  expect_everywhere(data, OrdinalVerdict::constant_scores, "is 4");
}

TEST(OrdinalVerdicts, CompleteSeparation) {
  OrdinalData data = simulate_scores({}, 20, 1);
  for (std::size_t i = 0; i < data.score.size(); ++i) {
    const double octaves = data.predictors(static_cast<Eigen::Index>(i), 0);
    data.score[i] = octaves < -1 ? 4 : octaves < 0 ? 3 : octaves < 1 ? 2 : octaves < 2 ? 1 : 0;
  }
  expect_everywhere(data, OrdinalVerdict::separated, "'octaves'");
}

TEST(OrdinalVerdicts, QuasiCompleteSeparationNamesTheEffectThatIsInfinite) {
  OrdinalData data = simulate_scores({}, 20, 1);
  for (std::size_t i = 0; i < data.score.size(); ++i)
    if (data.predictors(static_cast<Eigen::Index>(i), 1) == 1) data.score[i] = 4;  // object 2 is always seen
  expect_everywhere(data, OrdinalVerdict::separated, "'object2'");
  const OrdinalFit fit = fit_cumulative_link(data, {});
  EXPECT_THAT(fit.explanation, ::testing::Not(HasSubstr("octaves")));
}

TEST(OrdinalVerdicts, OneAnswerLessThanSeparatedIsEstimated) {
  OrdinalData data = simulate_scores({}, 20, 1);
  for (std::size_t i = 0; i < data.score.size(); ++i)
    if (data.predictors(static_cast<Eigen::Index>(i), 1) == 1) data.score[i] = i == 8 ? 3 : 4;
  for (const Link link : {Link::logit, Link::probit}) {
    const OrdinalFit fit = fit_cumulative_link(data, {.link = link});
    EXPECT_EQ(fit.verdict, OrdinalVerdict::estimated) << fit.explanation;
    EXPECT_GT(fit.coefficients[1], 1.5);
    EXPECT_LT(fit.coefficients[1], 12);
  }
}

TEST(OrdinalVerdicts, EmptyScoresAreSaidAndTheOthersFitted) {
  for (const int empty : {0, 2, 4}) {
    OrdinalData data = simulate_scores({}, 20, 1);
    for (int& score : data.score)
      if (score == empty) score = empty == 0 ? 1 : empty - 1;
    const OrdinalFit fit = fit_cumulative_link_mixed(data, {});
    EXPECT_EQ(fit.verdict, OrdinalVerdict::empty_scores);
    EXPECT_EQ(fit.empty_scores, std::vector<int>{empty});
    EXPECT_EQ(fit.cuts.size(), 3);
    EXPECT_NEAR(fit.coefficients[0], -1.1, 0.4);
  }
}

TEST(OrdinalVerdicts, OneParticipant) {
  const OrdinalData data = simulate_scores({}, 1, 3);
  expect_no_numbers(fit_cumulative_link_mixed(data, {}), OrdinalVerdict::one_participant, "one participant");
  EXPECT_TRUE(has_estimates(fit_cumulative_link(data, {}).verdict));
}

TEST(OrdinalVerdicts, SingularDesigns) {
  OrdinalData data = simulate_scores({}, 20, 1);
  data.predictors.conservativeResize(data.predictors.rows(), 4);
  data.predictor_names.emplace_back("copy");
  data.predictors.col(3) = 1000 - 12.5 * data.predictors.col(0).array();
  expect_everywhere(data, OrdinalVerdict::singular_design, "cannot be told apart");
  data.predictors.col(3).setConstant(7);
  expect_everywhere(data, OrdinalVerdict::singular_design, "'copy'");
  data.predictors.col(3) = 1 - data.predictors.col(1).array() - data.predictors.col(2).array();
  expect_everywhere(data, OrdinalVerdict::singular_design, "cannot be told apart");
}

TEST(OrdinalVerdicts, ParticipantsWhoEachGiveOneScoreOnly) {
  OrdinalData data = simulate_scores({}, 20, 1);
  for (std::size_t i = 0; i < data.score.size(); ++i) data.score[i] = data.participant[i] % 5;
  for (const Link link : {Link::logit, Link::probit})
    expect_no_numbers(fit_cumulative_link_mixed(data, {.link = link}), OrdinalVerdict::participants_separated,
                      "Within participants");
}

TEST(OrdinalVerdicts, ParticipantsWhoEachStepAtAWidthOfTheirOwn) {
  OrdinalData data = simulate_scores({}, 20, 1);
  for (std::size_t i = 0; i < data.score.size(); ++i)
    data.score[i] = data.predictors(static_cast<Eigen::Index>(i), 0) < data.participant[i] % 5 - 2 ? 4 : 0;
  for (const Link link : {Link::logit, Link::probit}) {
    const OrdinalFit fit = fit_cumulative_link_mixed(data, {.link = link});
    EXPECT_FALSE(has_estimates(fit.verdict)) << word(fit.verdict) << " sd " << fit.participant_sd;
  }
}

TEST(OrdinalVerdicts, ParticipantsWhoDoNotDiffer) {
  test::OrdinalPopulation population;
  population.sd = 0;
  int at_bound = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const OrdinalData data = simulate_scores(population, 20, seed);
    const OrdinalFit fit = fit_cumulative_link_mixed(data, {});
    ASSERT_TRUE(has_estimates(fit.verdict)) << fit.explanation;
    if (fit.verdict != OrdinalVerdict::no_participant_variance) continue;
    ++at_bound;
    EXPECT_EQ(fit.participant_sd, 0);
    EXPECT_FALSE(fit.participant_sd_ci95().has_value());
    const OrdinalFit fixed = fit_cumulative_link(data, {});
    EXPECT_LT((fit.coefficients - fixed.coefficients).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_NEAR(fit.log_likelihood, fixed.log_likelihood, 1e-7);
    EXPECT_LT((fit.covariance - fixed.covariance).cwiseAbs().maxCoeff(), 1e-6);
  }
  EXPECT_GE(at_bound, 2);  // about half of such studies
  EXPECT_LE(at_bound, 9);
}

TEST(OrdinalVerdicts, UnitsOfAPredictorDoNotMatter) {
  OrdinalData data = simulate_scores({}, 20, 4);
  const OrdinalFit fit = fit_cumulative_link_mixed(data, {});
  data.predictors.col(0) = 1e6 + 1e-4 * data.predictors.col(0).array();
  const OrdinalFit scaled = fit_cumulative_link_mixed(data, {});
  ASSERT_EQ(scaled.verdict, OrdinalVerdict::estimated) << scaled.explanation;
  EXPECT_NEAR(scaled.coefficients[0] * 1e-4, fit.coefficients[0], 1e-5);
  EXPECT_NEAR(scaled.log_likelihood, fit.log_likelihood, 1e-5);
}

TEST(OrdinalVerdicts, WrongInputIsASentence) {
  const auto complaint = [](const OrdinalData& data, const OrdinalRequest& request) -> std::string {
    return test::complaint_of([&] { (void)fit_cumulative_link_mixed(data, request); });
  };
  OrdinalData data = simulate_scores({}, 3, 1);
  EXPECT_EQ(complaint(data, {.nodes = 0}), "nodes: wanted 1 (Laplace) to 100, found 0");
  data.score[4] = 5;
  EXPECT_EQ(complaint(data, {}), "score of observation 5: wanted 0 to 4, found 5");
  data = simulate_scores({}, 3, 1);
  data.predictors(2, 0) = nan;
  EXPECT_THAT(complaint(data, {}), HasSubstr("predictor 'octaves' of observation 3"));
  data = simulate_scores({}, 3, 1);
  data.participant.clear();
  EXPECT_THAT(complaint(data, {}), HasSubstr("participants: wanted a number for each score"));
  EXPECT_THAT(complaint(OrdinalData{}, {}), HasSubstr("at least one observation"));
}

}  // namespace
}  // namespace seamline::analysis
