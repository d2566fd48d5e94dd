// The block in R of documentation/how-to/use_from_python.md, with Debian's r-base-core.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "python_page.h"

namespace seamline {
namespace {

class PageForR : public test::PythonPage {};

TEST_F(PageForR, ReadsTheTablesOfAReport) {
  test::write_text(folder / "block.R", test::example_of("documentation/how-to/use_from_python.md", "r", 0));
  const test::Outcome outcome = in_folder("Rscript block.R 2>&1");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, testing::HasSubstr("receiver"));
  EXPECT_THAT(outcome.output, testing::HasSubstr("[1] 20"));
}

}  // namespace
}  // namespace seamline
