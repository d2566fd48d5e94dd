// `seamline lab evidence`: what is listed, a small page that is remade, and that a second run repeats no
// step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "laboratory/evidence/evidence_figure.h"
#include "run_program.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::read_text;
using testing::HasSubstr;

std::string remade(const std::string& page, const fs::path& out) {
  return "lab evidence " + page + " --small --out " + out.string();
}

TEST(Evidence, EveryPageIsListedAndIsThereForPeople) {
  const test::Outcome listed = test::run_seamline("lab evidence");
  EXPECT_EQ(listed.status, 0) << listed.output;
  for (const laboratory::EvidencePage& page : laboratory::evidence_pages()) {
    EXPECT_THAT(listed.output, HasSubstr("\n" + page.name + " ")) << page.name;
    EXPECT_TRUE(fs::exists(fs::path(SEAMLINE_SOURCE_DIR) / "documentation/evidence" / (page.name + ".md")))
        << page.name;
    EXPECT_FALSE(page.steps.empty() || page.small_steps.empty()) << page.name;
  }
}

TEST(Evidence, ASmallPageSaysByWhomAndHowItWasMade) {
  const fs::path out = test::fresh_folder("evidence");
  const test::Outcome first = test::run_built(remade("stability", out));
  ASSERT_EQ(first.status, 0) << first.output;
  const std::string page = read_text(out / "stability/stability.md");
  EXPECT_THAT(page, HasSubstr("Made by seamline "));
  EXPECT_THAT(page, HasSubstr("\nseamline lab evidence stability --small\n"));
  EXPECT_THAT(page, HasSubstr("| `order-of-answers`"));
  const test::Outcome again = test::run_built(remade("stability", out));
  EXPECT_EQ(again.status, 0) << again.output;
  EXPECT_THAT(again.output, HasSubstr("cases, made before"));
  EXPECT_EQ(read_text(out / "stability/stability.md"), page);
}

TEST(Evidence, AFigureAndATableOfSpeedAreMade) {
  const fs::path out = test::fresh_folder("evidence-speed");
  const test::Outcome outcome = test::run_built(remade("speed", out));
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(read_text(out / "speed/bench.svg"), HasSubstr("</svg>"));
  EXPECT_THAT(read_text(out / "speed/speed.md"), HasSubstr("![bench.svg](bench.svg)"));
}

TEST(Evidence, CurvesGoThroughTheMeansOfATable) {
  const fs::path out = test::fresh_folder("evidence-curves");
  test::write_text(
      out / "true_coverage.csv",
      "way,people,coverage_percent\njoint,5,94\njoint,5,96\njoint,10,93\nlines,5,90\nlines,10,\n");
  laboratory::draw_evidence(out, laboratory::evidence_page("coverage").figures.front());
  const std::string script = read_text(out / "true_coverage.gnuplot");
  EXPECT_THAT(script, HasSubstr("5 95\n10 93\n"));
  EXPECT_THAT(script, HasSubstr("\n5 90\nEOD"));
  EXPECT_THAT(read_text(out / "true_coverage.svg"), HasSubstr("</svg>"));
}

TEST(Evidence, APageThatIsNotThereIsNamed) {
  const test::Outcome outcome = test::run_seamline("lab evidence coverge");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("did you mean coverage?"));
}

}  // namespace
}  // namespace seamline
