// The blocks of documentation/how-to/use_from_r.md, in one session, with Debian's r-base-core.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pages.h"
#include "python_page.h"

namespace seamline {
namespace {

class PageForR : public test::PythonPage {};

TEST_F(PageForR, RunsFromACommandToACurveAndAFit) {
  std::string script;
  for (const test::PageBlock& block : test::read_manual_page(std::filesystem::path(SEAMLINE_SOURCE_DIR) /
                                                             "documentation/how-to/use_from_r.md")
                                          .blocks)
    script += block.text;
  test::write_text(folder / "blocks.R", script);
  const test::Outcome outcome = in_folder("SEAMLINE=" SEAMLINE_PROGRAM " Rscript blocks.R 2>&1");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, testing::HasSubstr("participants.csv"));
  EXPECT_THAT(outcome.output, testing::HasSubstr("receiver"));
  EXPECT_THAT(outcome.output, testing::HasSubstr("[1] 20"));
  EXPECT_THAT(outcome.output, testing::HasSubstr("| threshold "));
  EXPECT_TRUE(std::filesystem::is_regular_file(folder / "curves.png"));
}

}  // namespace
}  // namespace seamline
