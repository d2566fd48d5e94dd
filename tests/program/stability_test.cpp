// `seamline lab stability` as people run it.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "run_program.h"

namespace seamline {
namespace {

using test::run_seamline;

TEST(StabilityCommand, PrintsALineACaseAndPasses) {
  const test::Outcome outcome = run_seamline("lab stability --only ratio-denominator-0");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("pass  light/ratio-denominator-0: "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("1 of 1 cases passed"), std::string::npos) << outcome.output;
}

TEST(StabilityCommand, ListsItsCasesWithoutRunningThem) {
  const test::Outcome outcome = run_seamline("lab stability --list");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_GE(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 60);
}

TEST(StabilityCommand, GivesData) {
  const test::Outcome outcome = test::run_built("lab stability --only quest_plus --json 2>/dev/null");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const std::size_t begin = outcome.output.find('{');
  ASSERT_NE(begin, std::string::npos);
  const nlohmann::json report =
      nlohmann::json::parse(outcome.output.substr(begin, outcome.output.rfind('}') - begin + 1));
  EXPECT_GE(report["cases"], 5);
  EXPECT_EQ(report["failed"], 0);
}

TEST(StabilityCommand, AnUnknownCaseIsWrongInput) {
  const test::Outcome outcome = run_seamline("lab stability --only nonsense");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.output.find("--only: wanted the name or the group of a case"), std::string::npos)
      << outcome.output;
}

}  // namespace
}  // namespace seamline
