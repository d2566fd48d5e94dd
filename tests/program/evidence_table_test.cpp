// Tables of evidence pages: what is computed from a step's tables, what is taken from what it printed, and
// that each table on a page is the file that its mark names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "laboratory/evidence/evidence_page.h"
#include "laboratory/evidence/marked_page.h"
#include "run_program.h"
#include "support/text/error.h"

namespace seamline::laboratory {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using Rows = std::vector<std::vector<std::string>>;

const fs::path evidence_folder = fs::path(SEAMLINE_SOURCE_DIR) / "documentation/evidence";

/// Pages whose tables people still write.
const std::vector<std::string> written_by_hand = {"predictions.md"};

TEST(EvidenceTable, SummarisesRowsByTheirValues) {
  const fs::path folder = test::fresh_folder("evidence-table");
  test::write_text(folder / "raw.csv",
                   "people,way,artifact,covers\n5,joint,shadow,96\n5,joint,overlap,93\n5,lines,shadow,80\n"
                   "5,joint,all,50\n10,joint,shadow,95.5\n10,joint,overlap,\n");
  const EvidenceTable table{
      .file = "made.csv",
      .from = {{"", "raw.csv"}},
      .heading = "people",
      .row_of = {"people"},
      .columns = {{.heading = "joint",
                   .of = "covers",
                   .where = {{"way", "joint"}},
                   .shows = Summary::mean_and_lowest,
                   .decimals = 1},
                  {.heading = "range", .of = "covers", .where = {{"way", "joint"}}, .shows = Summary::range},
                  {.heading = "lines", .of = "covers", .where = {{"way", "lines"}}},
                  {.heading = "rows", .of = "", .shows = Summary::rows}},
      .but_not = {{"artifact", "all"}}};
  const TextTable made = summarised(table, folder);
  EXPECT_THAT(made.columns, ElementsAre("people", "joint", "range", "lines", "rows"));
  EXPECT_EQ(made.rows,
            (Rows{{"5", "94.5 (93)", "93 to 96", "80", "3"}, {"10", "95.5 (96)", "96", "–", "2"}}));
  EXPECT_EQ(markdown_of({.columns = {"a", "b"}, .rows = {{"x", "12345"}, {"y", "–"}}}),
            "| a | b |\n| --- | ---: |\n| x | 12,345 |\n| y | – |\n");
}

TEST(EvidenceTable, ACellThatStandsForTwoTextsIsRefused) {
  const fs::path folder = test::fresh_folder("evidence-table-two");
  test::write_text(folder / "raw.csv", "name,value\na,1\na,2\n");
  const EvidenceTable table{.file = "made.csv",
                            .from = {{"", "raw.csv"}},
                            .heading = "name",
                            .row_of = {"name"},
                            .columns = {{.heading = "value", .of = "value"}}};
  EXPECT_THROW((void)summarised(table, folder), InputError);
}

TEST(EvidenceTable, RowsMayBeFiles) {
  const fs::path folder = test::fresh_folder("evidence-table-files");
  test::write_text(folder / "one.csv", "spp,error\n4,0.25\n8,0.125\n");
  test::write_text(folder / "two.csv", "spp,error\n4,0.5\n");
  const EvidenceTable table{.file = "made.csv",
                            .from = {{"first", "one.csv"}, {"second", "two.csv"}},
                            .heading = "file",
                            .row_of = {},
                            .columns = {{.heading = "at 4",
                                         .of = "error",
                                         .where = {{"spp", "4"}},
                                         .shows = Summary::mean,
                                         .decimals = 2}}};
  EXPECT_EQ(summarised(table, folder).rows, (Rows{{"first", "0.25"}, {"second", "0.50"}}));
}

TEST(EvidenceTable, IsTakenFromWhatAStepPrinted) {
  const PrintedTable bars{.file = "a.csv", .step = "s", .columns = {"name", "n"}, .last_of_a_name = true};
  EXPECT_EQ(printed_table(bars, "[ RUN ] x\n| name | n |\n| --- | --- |\n| a | 1 |\n| a | 2 |\n").rows,
            (Rows{{"a", "2"}}));
  const PrintedTable blanks{.file = "b.csv", .step = "s", .columns = {"fault", "tries", "note"}};
  EXPECT_EQ(printed_table(blanks,
                          "fault          tries\nkill of study     12\nfull disk          3  refused\nend\n")
                .rows,
            (Rows{{"kill of study", "12", ""}, {"full disk", "3", "refused"}}));
  const PrintedTable own_heading{.file = "d.csv", .step = "s", .columns = {"answers", "s a 10,000 answers"}};
  EXPECT_EQ(printed_table(own_heading, "answers  s a 10,000 answers\n  12528       4.3\n").rows,
            (Rows{{"12528", "4.3"}}));
  const PrintedTable commas{.file = "c.csv", .step = "s", .columns = {"form", "x"}};
  EXPECT_EQ(printed_table(commas, "form,x\nnormal,0.5\n").rows, (Rows{{"normal", "0.5"}}));
}

TEST(EvidencePages, EachMarkedTableIsItsFile) {
  std::size_t marks = 0;
  for (const auto& entry : fs::directory_iterator(evidence_folder)) {
    if (entry.path().extension() != ".md") continue;
    const std::string text = test::read_text(entry.path());
    EXPECT_EQ(with_marked_parts(text, entry.path().stem().string(), evidence_folder), text)
        << entry.path() << ": seamline lab evidence PAGE --tables --pages documentation/evidence";
    marks += marks_of(text).size();
  }
  EXPECT_GE(marks, 10U);
}

TEST(EvidencePages, EachComputedTableIsThatOfTheFilesBesideIt) {
  std::size_t tables = 0;
  for (const EvidencePage& page : evidence_pages())
    for (const EvidenceTable& table : page.tables) {
      const fs::path folder = evidence_folder / page.name;
      if (std::any_of(table.from.begin(), table.from.end(),
                      [&](const TableSource& source) { return !fs::exists(folder / source.file); }))
        continue;
      EXPECT_EQ(test::read_text(folder / table.file), csv_of(summarised(table, folder))) << table.file;
      ++tables;
    }
  EXPECT_GE(tables, 5U);
}

TEST(EvidencePages, NoTableIsWrittenByHand) {
  for (const EvidencePage& page : evidence_pages()) {
    const std::string name = page.name + ".md";
    if (std::find(written_by_hand.begin(), written_by_hand.end(), name) != written_by_hand.end()) continue;
    const std::string text = test::read_text(evidence_folder / name);
    EXPECT_THAT(unmarked_tables(text), ElementsAre()) << name;
    EXPECT_THAT(text, HasSubstr("/made.csv -->\n")) << name << " does not say by whom it was made";
  }
}

}  // namespace
}  // namespace seamline::laboratory
