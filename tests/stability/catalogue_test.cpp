#include "laboratory/stability/catalogue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "laboratory/stability/convergence_cases.h"
#include "laboratory/stability/run_cases.h"
#include "support/text/error.h"

namespace seamline::stability {
namespace {

TEST(Catalogue, HasAtLeastSixtyCasesWithNamesOfTheirOwn) {
  std::set<std::string> names;
  std::map<std::string, int> groups;
  for (const StabilityCase& one : stability_catalogue()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    ++groups[one.group];
  }
  EXPECT_GE(names.size(), 60U);
  for (const char* group : {"light", "space", "depth", "bounds", "statistics", "quest_plus", "convergence"})
    EXPECT_GE(groups[group], 5) << group;
  EXPECT_EQ(groups.size(), 7U);
}

TEST(Catalogue, SaysOfEveryCaseWhatIsTriedAndWhereItsToleranceComesFrom) {
  for (const StabilityCase& one : stability_catalogue()) {
    for (const std::string* text : {&one.tried, &one.expected, &one.unit, &one.reason})
      EXPECT_FALSE(text->empty()) << one.name;
    EXPECT_GT(one.reason.size(), 15U) << one.name;
    EXPECT_TRUE(one.tolerance >= 0 && std::isfinite(one.tolerance)) << one.name;
  }
}

TEST(Catalogue, CasesWithoutRendersPass) {
  for (const char* group : {"statistics", "quest_plus"})
    for (const StabilityCase& one : chosen_cases(group)) {
      const CaseOutcome outcome = run_case(one, {.threads = 2});
      EXPECT_TRUE(outcome.passed) << outcome_line(outcome);
    }
  for (const char* name : {"ratio-unchanged",
                           "ratio-exposures",
                           "albedo-0",
                           "albedo-0.999",
                           "albedo-1",
                           "albedo-1-fast",
                           "bounces-0",
                           "bounces-1",
                           "bounces-64",
                           "sun-1e8-lit",
                           "sun-1e8-shadow",
                           "grazing-sun-floor",
                           "grazing-sun-turned",
                           "object-touches-floor",
                           "object-1e-4-above-floor",
                           "white-ball",
                           "seam-full",
                           "jumps-1e6",
                           "impossible-lights",
                           "planted-no-number",
                           "far-products",
                           "options-no-number",
                           "strongest-light-fast",
                           "strongest-light-path"}) {
    const CaseOutcome outcome = run_case(chosen_cases(name).front(), {.threads = 2});
    EXPECT_TRUE(outcome.passed) << outcome_line(outcome);
  }
}

TEST(Catalogue, AnUnknownNameIsASentence) {
  EXPECT_THROW((void)chosen_cases("no-such-case"), InputError);
  EXPECT_EQ(chosen_cases("").size(), stability_catalogue().size());
}

StabilityCase case_that(const std::function<Finding(const StabilityOptions&)>& run) {
  return {.group = "light",
          .name = "made-up",
          .tried = "a",
          .expected = "b",
          .unit = "c",
          .tolerance = 1,
          .reason = "d",
          .run = run};
}

TEST(RunCase, NotANumberAndAnExceptionFail) {
  EXPECT_TRUE(run_case(case_that([](const StabilityOptions&) { return Finding{1, "found"}; }), {}).passed);
  EXPECT_FALSE(run_case(case_that([](const StabilityOptions&) {
                          return Finding{1.001, "found"};
                        }),
                        {})
                   .passed);
  EXPECT_FALSE(run_case(case_that([](const StabilityOptions&) {
                          return Finding{std::nan(""), "found"};
                        }),
                        {})
                   .passed);
  const CaseOutcome thrown =
      run_case(case_that([](const StabilityOptions&) -> Finding { throw std::runtime_error("broken"); }), {});
  EXPECT_FALSE(thrown.passed);
  EXPECT_EQ(thrown.finding.found, "stopped: broken");
  EXPECT_EQ(outcome_line(thrown).rfind("FAIL", 0), 0U);
}

TEST(RunCase, JsonHoldsEveryOutcome) {
  const std::vector<CaseOutcome> outcomes = {run_case(case_that([](const StabilityOptions&) {
                                                        return Finding{0.5, "found"};
                                                      }),
                                                      {}),
                                             run_case(case_that([](const StabilityOptions&) {
                                                        return Finding{std::nan(""), "nothing"};
                                                      }),
                                                      {})};
  const nlohmann::json report = nlohmann::json::parse(outcomes_json(outcomes));
  EXPECT_EQ(report["format"], "seamline stability 1");
  EXPECT_EQ(report["failed"], 1);
  ASSERT_EQ(report["results"].size(), 2U);
  EXPECT_EQ(report["results"][0]["error"], 0.5);
  EXPECT_EQ(report["results"][1]["error"], "nan");
  EXPECT_EQ(report["results"][1]["passed"], false);
  EXPECT_NE(outcomes_markdown(outcomes).find("| `made-up` |"), std::string::npos);
}

TEST(Orders, AnEstimatorOfAnotherOrderFails) {
  OrderSeries series{.name = "made up",
                     .line = "made up",
                     .tried = "made up",
                     .expected = -0.5,
                     .tolerance = 0.05,
                     .reason = "made up",
                     .panel = 0,
                     .measure = [] {
                       return std::vector<std::pair<double, double>>{{1, 1}, {100, 0.1}};
                     }};
  EXPECT_NEAR(try_order(series).error, 0, 1e-12);
  series.measure = [] { return std::vector<std::pair<double, double>>{{1, 1}, {100, 0.2}}; };  // a bias stays
  EXPECT_GT(try_order(series).error, series.tolerance);
}

}  // namespace
}  // namespace seamline::stability
