#include "support/text/csv_read.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "support/arithmetic/random.h"
#include "support/text/csv.h"
#include "support/text/limits.h"
#include "support/text/printable.h"

namespace seamline {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Rows = std::vector<std::vector<std::string>>;

const std::array<std::string, 2> a_and_b = {"a", "b"};

/// The rows of a and b, each with its line before them.
Rows rows_of(const std::string& text) {
  Rows rows;
  read_csv("t.csv", text, a_and_b, [&](const CsvRow& row) {
    rows.push_back(row.values);
    rows.back().insert(rows.back().begin(), std::to_string(row.line));
  });
  return rows;
}

std::string complaint_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

std::string complaint_of(const std::string& text) {
  return complaint_of([&] { rows_of(text); });
}

TEST(CsvRead, QuotedValuesHoldCommasQuotesAndLineEnds) {
  EXPECT_EQ(rows_of("a,b\n\"1,5\",\"say \"\"so\"\"\"\n\"two\r\nlines\n\n\",x\n3,4\n"),
            (Rows{{"2", "1,5", "say \"so\""}, {"3", "two\r\nlines", "x"}, {"7", "3", "4"}}));
}

TEST(CsvRead, EveryLineEndAMarkBlanksAndEmptyLinesAreTheSameTable) {
  const Rows rows = {{"2", "1", "2"}, {"3", "3", "4"}};
  for (const std::string end : {"\n", "\r\n", "\r"})
    for (const std::string mark : {"", "\xef\xbb\xbf"})
      for (const std::string last : {"", "x"}) {
        EXPECT_EQ(rows_of(mark + "a,b" + end + "1,2" + end + "3,4" + (last.empty() ? end : "")), rows);
        EXPECT_EQ(rows_of(mark + "\" a \"\t, b" + end + " 1 ,\" 2\"" + end + "3\t,4 " + end), rows);
      }
  EXPECT_EQ(rows_of("\n \na,b\n\n1,2\n\t\n\n3,4"), (Rows{{"5", "1", "2"}, {"8", "3", "4"}}));
}

TEST(CsvRead, ColumnsAreFoundByNameAndOthersIgnored) {
  EXPECT_EQ(rows_of(",b,note,a,\n0,2,\"x,y\",1,\n"), (Rows{{"2", "1", "2"}}));  // pandas names no index
  EXPECT_EQ(rows_of("a;b;c\n1;2;\"x;y\"\n"), (Rows{{"2", "1", "2"}}));
  EXPECT_EQ(rows_of("a,b,\"x;y\"\n1;0,2,\n"), (Rows{{"2", "1;0", "2"}}));
  EXPECT_EQ(rows_of("\na\tb\tc\n1\t2\t\n\n3\t\t5\n"), (Rows{{"3", "1", "2"}, {"5", "3", ""}}));
}

TEST(CsvRead, ASentenceForEachFault) {
  EXPECT_EQ(complaint_of(""), "t.csv: line 1: wanted a header with the columns a,b, found an empty file");
  EXPECT_EQ(complaint_of("\n \n"), complaint_of(""));
  EXPECT_EQ(complaint_of("a,c\n"),
            "t.csv: line 1: wanted a header with the columns a,b, found no column 'b' in 'a,c'");
  EXPECT_EQ(complaint_of("\na,b,a\n1,2,3\n"),
            "t.csv: line 2: wanted a header that names every column once, found two columns 'a'");
  EXPECT_EQ(complaint_of("a,b\n1,2\n1\n"),
            "t.csv: line 3: wanted 2 values, as the header has columns, found 1");
  EXPECT_EQ(complaint_of("a,b\n\n\"x\ny\",1,2\n"),
            "t.csv: line 3: wanted 2 values, as the header has columns, found 3 (numbers have a decimal "
            "point, no comma)");
  EXPECT_THAT(complaint_of("a,b\n1,2\n\"1\n1,2\n3,4\n"),
              HasSubstr("line 3: wanted quotes around a whole value, doubled inside it, found a quote that "
                        "is not closed"));
  EXPECT_THAT(complaint_of("a,b\n1,2\n1,5\"\n"), HasSubstr("line 3: wanted quotes around a whole value"));
  EXPECT_THAT(complaint_of("a,b\n\"1\"2,3\n"), HasSubstr("line 2: wanted quotes around a whole value"));
  EXPECT_EQ(complaint_of(std::string("a,b\n1,2\n1,\0002\n", 13)),
            "t.csv: line 3: wanted text in UTF-8, found a byte of 0, as files of UTF-16 have them");
}

TEST(CsvRead, NumbersAreWholeValues) {
  const auto number = [](const std::string& text) {
    double value = 0;
    read_csv("t.csv", "a,b\n\"" + text + "\",\n", a_and_b,
             [&](const CsvRow& row) { value = number_at(row, 0); });
    return value;
  };
  EXPECT_EQ(number("64.5"), 64.5);
  EXPECT_EQ(number(" -1e-3 "), -1e-3);
  EXPECT_EQ(number("5e-324"), 5e-324);
  const auto refused = [&](const std::string& text) { return complaint_of([&] { (void)number(text); }); };
  EXPECT_EQ(refused("64,5"),
            "t.csv: line 2: a: wanted a number with a decimal point and no comma, found '64,5'");
  EXPECT_EQ(refused("1,024.5"),
            "t.csv: line 2: a: wanted a number with a decimal point and no comma, found '1,024.5'");
  EXPECT_EQ(refused(""), "t.csv: line 2: a: wanted a number, found nothing");
  for (const std::string text : {"nan", "inf", "-inf", "0x10", "5 6", "x", "x,y", "1e5.", "--1"})
    EXPECT_EQ(refused(text), "t.csv: line 2: a: wanted a number, found '" + text + "'");
  for (const std::string text : {"1e309", "1e-400"})
    EXPECT_EQ(refused(text),
              "t.csv: line 2: a: wanted a number of at least 4.9e-324 and at most 1.8e308 in "
              "size, found '" +
                  text + "'");
}

TEST(CsvRead, CountsSayTheirLimit) {
  const auto count = [](const std::string& text) {
    std::int64_t value = 0;
    read_csv("t.csv", "a,b\n" + text + ",\n", a_and_b,
             [&](const CsvRow& row) { value = count_at(row, 0, 1'000'000, "1e6"); });
    return value;
  };
  EXPECT_EQ(count("1e6"), 1'000'000);
  EXPECT_EQ(count("-0"), 0);
  for (const std::string text : {"1000001", "-1", "2.5", "5.00000001"})
    EXPECT_EQ(complaint_of([&] { (void)count(text); }),
              "t.csv: line 2: a: wanted a whole number from 0 to 1e6, found '" + text + "'");
}

TEST(CsvRead, OneLongValueManyColumnsAndManyRowsAreHeld) {
  const std::string most(static_cast<std::size_t>(8 << 20), 'x');
  EXPECT_EQ(rows_of("a,b\n\"" + most + "\",1\n"), (Rows{{"2", most, "1"}}));
  EXPECT_THAT(complaint_of("a,b" + std::string(limits::largest_csv_columns, ',') + "\n"),
              HasSubstr("line 1: wanted at most 10000 columns, found more"));
  EXPECT_THAT(complaint_of("a,b\n" + std::string(8 << 20, ',') + "\n"),
              HasSubstr("line 2: wanted at most 10000 columns, found more"));
  std::string text = "a,b\n";
  for (std::int64_t row = 0; row <= limits::largest_csv_rows; ++row) text += ",\n";
  std::int64_t taken = 0;
  EXPECT_THAT(complaint_of([&] { read_csv("t.csv", text, a_and_b, [&](const CsvRow&) { ++taken; }); }),
              HasSubstr("line 1000002: wanted at most 1000000 rows, found more"));
  EXPECT_EQ(taken, limits::largest_csv_rows);
}

/// What `csv_text` writes is what is read, whatever letters it is made of.
TEST(CsvRead, ReadsWhatIsWritten) {
  Random random(5, 0);
  const std::string letters = "ab1 ,;\"\n\r\t=\xc3\xa4";
  for (int round = 0; round < 2000; ++round) {
    CsvTable table{.name = "t", .columns = {{"b", "", ""}, {"a", "", ""}}, .rows = {}};
    Rows expected;
    for (std::uint64_t row = random.below(4); row > 0; --row) {
      std::vector<std::string> values(2);
      for (std::string& value : values) {
        value = "x";  // no blanks outside, no formula
        for (std::uint64_t letter = random.below(6); letter > 0; --letter)
          value += letters[static_cast<std::size_t>(random.below(letters.size()))];
        value += "x";
      }
      table.rows.push_back({values[1], values[0]});
      for (std::string& value : values) value = clean_text(value);  // halves of letters are none
      expected.push_back(values);
    }
    Rows read;
    read_csv("t.csv", csv_text(table), a_and_b, [&](const CsvRow& row) { read.push_back(row.values); });
    ASSERT_EQ(read, expected) << csv_text(table);
  }
}

}  // namespace
}  // namespace seamline
