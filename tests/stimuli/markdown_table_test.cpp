#include "support/files/markdown_table.h"

#include <gtest/gtest.h>

namespace seamline {
namespace {

TEST(MarkdownTable, ColumnsArePaddedByCharactersAndNumbersStandRight) {
  const CsvTable table{.name = "t",
                       .columns = {{"name", "", ""}, {"size", "m", ""}, {"count", "", ""}},
                       .rows = {{std::string("Höhe"), 0.12345, std::int64_t{7}},
                                {std::string("a|b"), std::monostate{}, std::int64_t{12345}}}};
  EXPECT_EQ(markdown_table(table),
            "| name | size (m) | count |\n"
            "| ---- | -------: | ----: |\n"
            "| Höhe |    0.123 |     7 |\n"
            "| a\\|b |        – | 12345 |\n");
}

}  // namespace
}  // namespace seamline
