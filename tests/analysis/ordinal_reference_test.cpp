// Estimates of R's package `ordinal` (clm, and clmm by Laplace and by 15 nodes) on two simulated studies.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "analysis/ordinal/likelihood/mixed_fit.h"

namespace seamline::analysis {
namespace {

OrdinalData data_of(const nlohmann::json& study) {
  OrdinalData data;
  const std::vector<double> levels = study.at("levels");
  const int people = study.at("n_participants");
  data.score = study.at("scores").get<std::vector<int>>();
  data.predictors.resize(static_cast<Eigen::Index>(data.score.size()), 3);
  data.predictor_names = {"lx", "object2", "object3"};
  Eigen::Index row = 0;
  for (int p = 0; p < people; ++p)
    for (int object = 1; object <= 3; ++object)
      for (const double level : levels) {
        data.predictors.row(row++) << std::log2(level) - 5, object == 2, object == 3;
        data.participant.push_back(p);
      }
  return data;
}

/// Compares cuts, coefficients, likelihood and standard errors. R's Laplace likelihood of the first study
/// is 9.6e-4 above the Laplace approximation at R's own estimates (computed outside this program, modes to
/// the last digit), because R stops the search for the modes early: nearly all of the 1e-3 allowed. R's own
/// standard errors of clmm come from differences, hence the wider tolerance.
void expect_same(const OrdinalFit& fit, const nlohmann::json& expected, double se_tolerance) {
  ASSERT_TRUE(has_estimates(fit.verdict)) << fit.explanation;
  EXPECT_NEAR(fit.log_likelihood, expected.at("logLik").get<double>(), 1e-3);
  EXPECT_NEAR(fit.aic, expected.at("AIC").get<double>(), 2e-3);
  const nlohmann::json& alpha = expected.at("alpha");
  ASSERT_EQ(fit.cut_names.size(), alpha.size());
  for (std::size_t c = 0; c < fit.cut_names.size(); ++c) {
    const auto k = static_cast<Eigen::Index>(c);
    EXPECT_NEAR(fit.cuts[k], alpha.at(fit.cut_names[c]).get<double>(), 1e-3) << fit.cut_names[c];
    EXPECT_NEAR(std::sqrt(fit.covariance(k, k)), expected.at("se").at(fit.cut_names[c]).get<double>(),
                se_tolerance);
  }
  const nlohmann::json& beta = expected.at("beta");
  ASSERT_EQ(fit.coefficient_names.size(), beta.size());
  for (std::size_t j = 0; j < fit.coefficient_names.size(); ++j) {
    const std::string& name = fit.coefficient_names[j];
    const auto k = static_cast<Eigen::Index>(j);
    EXPECT_NEAR(fit.coefficients[k], beta.at(name).get<double>(), 1e-3) << name;
    const Eigen::Index at = fit.cuts.size() + k;
    EXPECT_NEAR(std::sqrt(fit.covariance(at, at)), expected.at("se").at(name).get<double>(), se_tolerance)
        << name;
  }
  if (!expected.contains("sd_participant")) return;
  EXPECT_NEAR(fit.participant_sd, expected.at("sd_participant").get<double>(), 1e-3);
  const std::vector<double> effects = expected.at("ranef");
  for (std::size_t p = 0; p < effects.size(); ++p)
    EXPECT_NEAR(fit.participant_effect[static_cast<Eigen::Index>(p)], effects[p], 1e-3);
  // R reports the standard error of log sd as ST1.
  const Eigen::Index last = fit.covariance.rows() - 1;
  EXPECT_NEAR(std::sqrt(fit.covariance(last, last)) / fit.participant_sd,
              expected.at("se").at("ST1").get<double>(), 5e-3);
}

class OrdinalReference : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ifstream in(SEAMLINE_SOURCE_DIR "/tests/data/ordinal_fits.json");
    cases_ = nlohmann::json::parse(in).at("cases");
    ASSERT_EQ(cases_.size(), 2u);
  }
  nlohmann::json cases_;
};

TEST_F(OrdinalReference, FixedEffects) {
  for (const nlohmann::json& study : cases_) {
    OrdinalData data = data_of(study);
    expect_same(fit_cumulative_link(data, {}), study.at("clm"), 1e-5);
    data.predictors.conservativeResize(data.predictors.rows(), 1);
    data.predictor_names.resize(1);
    expect_same(fit_cumulative_link(data, {}), study.at("clm_width_only"), 1e-5);
  }
}

TEST_F(OrdinalReference, ParticipantsByLaplace) {
  for (const nlohmann::json& study : cases_)
    expect_same(fit_cumulative_link_mixed(data_of(study), {.nodes = 1}), study.at("clmm_laplace"), 1e-3);
}

TEST_F(OrdinalReference, ParticipantsByFifteenNodes) {
  for (const nlohmann::json& study : cases_)
    expect_same(fit_cumulative_link_mixed(data_of(study), {.nodes = 15}), study.at("clmm_agq15"), 1e-3);
}

TEST_F(OrdinalReference, AnEmptyScoreIsSaid) {
  const OrdinalFit fit = fit_cumulative_link_mixed(data_of(cases_.at(1)), {});
  EXPECT_EQ(fit.verdict, OrdinalVerdict::empty_scores);
  EXPECT_EQ(fit.empty_scores, std::vector<int>{3});
  EXPECT_EQ(fit.cut_names, (std::vector<std::string>{"0|1", "1|2", "2|4"}));
  EXPECT_NE(fit.explanation.find("score 3"), std::string::npos) << fit.explanation;
}

}  // namespace
}  // namespace seamline::analysis
