// The same with 200 kills; about ten minutes.
#include "window_kill.h"

namespace seamline::study::app {
namespace {

TEST(WindowKillFull, TwoHundredSessions) {
  if (const std::string missing = test::what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
  const test::KillTally tally =
      test::kill_sessions(std::filesystem::path(SEAMLINE_TEST_OUTPUT) / "app" / "kill-full", 200, 200);
  EXPECT_EQ(tally.kills, 200);
  EXPECT_GT(tally.accepted, 200);
  EXPECT_GE(tally.stored, tally.accepted);
  EXPECT_GT(tally.continued, 20);
}

}  // namespace
}  // namespace seamline::study::app
