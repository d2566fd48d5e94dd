// The demo with the study that is shipped; its files are looked at in demo_test.cpp, with a smaller one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.h"

namespace seamline {
namespace {

TEST(ShippedDemo, EndsWithAReport) {
  const std::filesystem::path out = test::fresh_folder("demo-full") / "out";
  const test::Outcome outcome = test::run_seamline("demo --spp 2 --out " + out.string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, testing::HasSubstr((out / "report" / "report.html").string()));
  EXPECT_THAT(test::read_text(out / "report" / "report.html"), testing::HasSubstr("20 simulated observers"));
  EXPECT_EQ(test::run_seamline("verify " + (out / "set").string()).status, 0);
}

}  // namespace
}  // namespace seamline
