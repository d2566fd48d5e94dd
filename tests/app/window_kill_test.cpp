#include "window_kill.h"

namespace seamline::study::app {
namespace {

TEST(WindowKill, NothingAcceptedIsLostAndNothingIsDoubled) {
  if (const std::string missing = test::what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
  const test::KillTally tally =
      test::kill_sessions(std::filesystem::path(SEAMLINE_TEST_OUTPUT) / "app" / "kill", 5, 5);
  EXPECT_EQ(tally.kills, 5);
  EXPECT_GE(tally.stored, tally.accepted);
}

}  // namespace
}  // namespace seamline::study::app
