#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.h"

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

}  // namespace
}  // namespace seamline
