// How often intervals of contrasts hold the planted value and how often equal things are called different,
// with standard errors over participants beside the model's own. By hand.
#include <gtest/gtest.h>

#include <cstdio>

#include "analysis/ordinal/contrasts/study_contrasts.h"
#include "analysis/ordinal/contrasts/study_model.h"
#include "support/running/parallel.h"
#include "tests/analysis/ordinal_study_people.h"

namespace seamline::analysis {
namespace {

using test::simulate_answers;
using test::simulated_groups;
using test::StudyPopulation;

struct Rates {
  double over_participants = 0, of_model = 0;  ///< intervals of one contrast that exclude 0 though it is 0
  double family = 0;                           ///< families with any false "differs", single-step
  double model_family = 0;                     ///< the same with the model's own errors
};

/// The rates of one study: shares of its contrasts, and 0 or 1 for its families. Empty when the errors are
/// not over participants.
std::map<std::string, Rates> alarms_of(const StudyPopulation& population, int people, int index) {
  std::map<std::string, Rates> rates_of;
  const OrdinalStudy study =
      fit_ordinal_study(simulate_answers(population, people, 1000 + static_cast<std::uint64_t>(index)),
                        simulated_groups(people), {.fit = {.nodes = 5, .threads = 1}});
  if (study.errors != ErrorSource::participants) return rates_of;
  const Eigen::Index cuts = study.fit.cuts.size(), effects = study.fit.coefficients.size();
  const Eigen::MatrixXd own = study.fit.covariance.block(cuts, cuts, effects, effects);
  const std::vector<ContrastFamily> families = study_contrasts(study.design, false);
  for (std::size_t f = 1; f < study.contrasts.size(); ++f) {  // the first question's slopes are not 0
    const ContrastTable& table = study.contrasts[f];
    const ContrastTable by_model =
        test_contrasts(families[f], study.fit.coefficients, own, Correction::single_step);
    Rates& rates = rates_of[table.question];
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const double share = 1 / static_cast<double>(table.rows.size());
      rates.over_participants += table.rows[i].p < 0.05 ? share : 0;
      rates.of_model += by_model.rows[i].p < 0.05 ? share : 0;
      if (table.rows[i].verdict == ContrastVerdict::differs) rates.family = 1;
      if (by_model.rows[i].verdict == ContrastVerdict::differs) rates.model_family = 1;
    }
  }
  return rates_of;
}

/// For every question whose differences are all 0.
std::map<std::string, Rates> false_alarms(const StudyPopulation& population, int people, int studies) {
  std::vector<std::map<std::string, Rates>> all(static_cast<std::size_t>(studies));
  run_parallel(studies, 0,
               [&](int s) { all[static_cast<std::size_t>(s)] = alarms_of(population, people, s); });
  std::map<std::string, Rates> means;
  for (const auto& one : all) {
    EXPECT_FALSE(one.empty());
    for (const auto& [question, rates] : one) {
      Rates& mean = means[question];
      mean.over_participants += rates.over_participants / studies;
      mean.of_model += rates.of_model / studies;
      mean.family += rates.family / studies;
      mean.model_family += rates.model_family / studies;
    }
  }
  return means;
}

void print(const char* what, const std::map<std::string, Rates>& all) {
  for (const auto& [question, rates] : all)
    std::printf("%s | %s | %.3f | %.3f | %.3f | %.3f\n", what, question.c_str(), rates.over_participants,
                rates.family, rates.of_model, rates.model_family);
}

TEST(OrdinalStudyFull, FalseAlarmsWhenParticipantsDifferInLevelOnly) {
  const auto rates = false_alarms({}, 20, 300);
  print("level only", rates);
  for (const auto& [question, rate] : rates) {
    EXPECT_LT(rate.over_participants, 0.07) << question;
    EXPECT_LT(rate.family, 0.085) << question;
  }
}

TEST(OrdinalStudyFull, FalseAlarmsWhenParticipantsDifferInSlopeAndArtifactToo) {
  StudyPopulation population;
  population.slope_sd = 0.25;
  population.artifact_sd = 0.6;
  const auto rates = false_alarms(population, 20, 300);
  print("slope and artifact too", rates);
  for (const auto& [question, rate] : rates) {
    EXPECT_LT(rate.over_participants, 0.07) << question;
    EXPECT_LT(rate.family, 0.085) << question;
  }
  EXPECT_GT(rates.at("Do artifacts differ at 512 px?").of_model, 0.1);  // why the model's own are not used
}

}  // namespace
}  // namespace seamline::analysis
