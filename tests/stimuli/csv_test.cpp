#include "support/text/csv.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seamline {
namespace {

std::string line_of(std::vector<CsvValue> values) {
  CsvTable table{.name = "t", .columns = {}, .rows = {}};
  for (std::size_t i = 0; i < values.size(); ++i) table.columns.push_back({std::to_string(i), "", ""});
  table.rows.push_back(std::move(values));
  const std::string text = csv_text(table);
  return text.substr(text.find('\n') + 1);
}

TEST(Csv, TextThatASpreadsheetWouldRunIsDefused) {
  for (const char* text : {"=1+1", "+1", "-1", "@A1"})
    EXPECT_EQ(line_of({text}), std::string("'") + text + "\n");
  EXPECT_EQ(line_of({"\t=1"}), "'\t=1\n");
  EXPECT_EQ(line_of({"\r=1"}), "\"'\r=1\"\n");
  EXPECT_EQ(line_of({"\n=1"}), "\"'\n=1\"\n");
  EXPECT_EQ(line_of({"=\"a\",1"}), "\"'=\"\"a\"\",1\"\n");
  CsvTable named{.name = "t", .columns = {{"=x", "", ""}}, .rows = {}};
  EXPECT_EQ(csv_text(named), "'=x\n");
}

TEST(Csv, NumbersAndHarmlessTextStayAsTheyAre) {
  EXPECT_EQ(line_of({-1.5, std::int64_t{-3}, std::monostate{}, std::nan(""), HUGE_VAL, "a-b", "p01", ""}),
            "-1.5,-3,,,,a-b,p01,\n");
}

}  // namespace
}  // namespace seamline
