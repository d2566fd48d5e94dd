// `seamline lab evidence`: what is listed, a small page that is remade, and that a second run repeats no
// step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

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
  EXPECT_THAT(page, HasSubstr("| quest_plus | 7 | 7 |"));
  EXPECT_THAT(read_text(out / "stability/made.csv"), HasSubstr("\ncases,20"));
  const test::Outcome again = test::run_built(remade("stability", out));
  EXPECT_EQ(again.status, 0) << again.output;
  EXPECT_THAT(again.output, HasSubstr("cases, made before"));
  EXPECT_EQ(read_text(out / "stability/stability.md"), page);
}

TEST(Evidence, AFigureAndATableOfSpeedAreMade) {
  const fs::path out = test::fresh_folder("evidence-speed");
  const test::Outcome outcome = test::run_built(remade("speed", out));
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(read_text(out / "speed/ratios.svg"), HasSubstr("</svg>"));
  EXPECT_THAT(read_text(out / "speed/speed.md"), HasSubstr("![ratios.svg](ratios.svg)"));
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

TEST(Evidence, PagesAreRenewedFromTheTablesBesideThem) {
  const fs::path pages = test::fresh_folder("evidence-pages");
  test::write_text(
      pages / "stability.md",
      "# One\n\n<!-- stability/groups.csv -->\nold\n\n<!-- stability/made.csv -->\nold\n\nEnd\n");
  const std::string command = "lab evidence stability --tables --pages " + pages.string();
  const test::Outcome missing = test::run_seamline(command);
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.output, HasSubstr("groups.csv: wanted a readable file"));
  fs::create_directories(pages / "stability");
  test::write_text(pages / "stability/cases.csv", "group,verdict\nlight,pass\nlight,FAIL\nspace,pass\n");
  test::write_text(pages / "stability/made.csv",
                   "step,date,seamline,processor,threads,processor_s\ncases,2026-11-27,1.0.0,CPU,2,150\n");
  const test::Outcome renewed = test::run_seamline(command);
  EXPECT_EQ(renewed.status, 0) << renewed.output;
  EXPECT_EQ(
      read_text(pages / "stability.md"),
      "# One\n\n<!-- stability/groups.csv -->\n| group | cases | passed |\n| --- | ---: | ---: |\n| light | 2 "
      "| 1 |\n| space | 1 | 1 |\n\n<!-- stability/made.csv -->\nMade by `seamline lab evidence stability`: "
      "seamline 1.0.0 on CPU, 2 threads (2026-11-27), 3 minutes of processor time.\n\nEnd\n");
  EXPECT_THAT(test::run_seamline("lab evidence stability --tables").output, HasSubstr("--pages"));
}

/// What a filter of steps names: "Suite" of "Suite.*" and of "Suite.OneTest".
std::vector<std::string> suites_of(const std::string& command) {
  const std::size_t at = command.find("--gtest_filter=");
  std::vector<std::string> suites;
  if (at == std::string::npos) return suites;
  std::istringstream patterns(command.substr(at + std::string("--gtest_filter=").size()));
  for (std::string pattern; std::getline(patterns, pattern, ':');)
    if (!pattern.starts_with('-')) suites.push_back(pattern.substr(0, pattern.find('.')));
  return suites;
}

TEST(Evidence, EveryTestThatAStepNamesIsThere) {
  std::string tests;
  for (const char* folder : {"tests/analysis", "tests/study"})
    for (const auto& entry : fs::directory_iterator(fs::path(SEAMLINE_SOURCE_DIR) / folder))
      if (entry.path().extension() == ".cpp") tests += read_text(entry.path());
  for (const laboratory::EvidencePage& page : laboratory::evidence_pages())
    for (const auto* steps : {&page.steps, &page.small_steps})
      for (const laboratory::EvidenceStep& step : *steps)
        for (const std::string& suite : suites_of(step.command))
          EXPECT_THAT(tests, HasSubstr("TEST(" + suite + ", ")) << page.name;
}

/// The table that a step is asked to write; empty where there is none.
std::string table_of(const std::string& command) {
  const std::string option = " --csv ";
  const std::size_t at = command.find(option);
  if (at == std::string::npos) return "";
  return command.substr(at + option.size(), command.find(' ', at + option.size()) - at - option.size());
}

void expect_small_form(const std::string& page) {
  const fs::path out = test::fresh_folder("evidence-" + page);
  const test::Outcome outcome = test::run_built(remade(page, out));
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(read_text(out / page / (page + ".md")), HasSubstr("This is the small form."));
  for (const laboratory::EvidenceStep& step : laboratory::evidence_page(page).small_steps) {
    const std::string table = table_of(step.command);
    if (table.empty()) continue;
    const std::string rows = read_text(out / page / table);
    EXPECT_GE(std::count(rows.begin(), rows.end(), '\n'), 2) << step.command << "\n" << rows;
  }
}

// The other pages' small forms are tests of CI themselves, or need what it has not (scale: benchmarks).
TEST(SmallForms, OfConvergenceEnds) {
  expect_small_form("convergence");
}
TEST(SmallForms, OfPredictionsEnds) {
  expect_small_form("predictions");
}
TEST(SmallForms, OfRealTimeEnds) {
  expect_small_form("real_time");
}
TEST(SmallForms, OfTrueErrorsEnds) {
  expect_small_form("true_errors");
}
TEST(SmallForms, OfGrowthEnds) {
  expect_small_form("growth");
}

TEST(SmallForms, OfPlanningEnds) {
  expect_small_form("planning");
}
TEST(SmallForms, OfDepthCamerasEnds) {
  expect_small_form("depth_cameras");
}
TEST(SmallForms, OfPicturesEnds) {
  expect_small_form("pictures");
}

TEST(Evidence, APageThatIsNotThereIsNamed) {
  const test::Outcome outcome = test::run_seamline("lab evidence coverge");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("did you mean coverage?"));
}

}  // namespace
}  // namespace seamline
