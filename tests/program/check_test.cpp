#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "run_program.h"
#include "sets/check.h"

namespace seamline {
namespace {

TEST(Check, BuiltinScenesKeepThePapersRules) {
  const test::Outcome outcome =
      test::run_seamline("check " + (test::studies() / "depth_resolution.toml").string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, testing::Not(testing::HasSubstr("BROKEN")));
}

TEST(Check, ABrokenRuleIsFound) {
  const auto folder = test::fresh_folder("check");
  // A teapot in the statue's place casts too short a shadow to cross three surfaces.
  test::write_text(folder / "study.toml", test::quick_study_with({{"builtin:statue", "builtin:teapot"}}));
  const test::Outcome outcome = test::run_seamline("check " + (folder / "study.toml").string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, testing::HasSubstr("BROKEN"));
}

TEST(Check, ThePageListsEveryRule) {
  const std::string page =
      test::read_text(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "documentation/reference/scene_rules.md");
  std::vector<std::string> rows;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("| ")) rows.push_back(line.substr(2, line.find(" |", 2) - 2));
  ASSERT_GE(rows.size(), 3U);
  rows.erase(rows.begin(), rows.begin() + 2);  // the table's head
  EXPECT_EQ(rows, renderer::scene_rules());
}

TEST(Check, WhatIsNotThereIsSaidInWords) {
  const auto folder = test::fresh_folder("check-nothing");
  // No sun, one object behind the camera, and of two that shape rules leave out one remains.
  const std::string all = "artifacts = [\"receiver\", \"shadow\", \"occlusion\", \"overlap\"]\nsuns = []";
  test::write_small_study(
      folder, test::small_study_with({{"artifacts = [\"receiver\"]", all},
                                      {"position_m = [-1.7, 0.0, -4.35]",
                                       "position_m = [0, 0, 40]\nexempt_from_shape_rules = true"},
                                      {"artifacts = [\"shadow\", \"overlap\"]", all},
                                      {"position_m = [-3.0, 0.0, -7.0]", "position_m = [0, 0, 40]"}}));
  const test::Outcome outcome = test::run_seamline("check " + (folder / "study.toml").string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, testing::HasSubstr("px, there is no sun"));
  EXPECT_THAT(outcome.output, testing::HasSubstr("statue is not in the picture"));
  EXPECT_THAT(outcome.output, testing::HasSubstr("casts no shadow: there is no sun"));
  const std::regex says_nothing(R"(\b-?(nan|inf)\b|:\s*(\n|$)|1e\+?300)");
  EXPECT_FALSE(std::regex_search(outcome.output, says_nothing)) << outcome.output;
  // Every rule that is printed is one of the list.
  std::set<std::string> printed;
  const std::regex line(R"((?:ok    |BROKEN)  \w+ +(.*?): )");
  for (auto it = std::sregex_iterator(outcome.output.begin(), outcome.output.end(), line);
       it != std::sregex_iterator(); ++it)
    printed.insert((*it)[1]);
  const std::vector<std::string> rules = renderer::scene_rules();
  EXPECT_EQ(printed, std::set<std::string>(rules.begin(), rules.end()));
}

}  // namespace
}  // namespace seamline
