// Text from outside: in messages, pages, tables and figures it is UTF-8 that can be shown, and not too long.
#include "support/text/printable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/arithmetic/random.h"
#include "support/files/gnuplot.h"
#include "support/text/csv.h"
#include "support/text/error.h"
#include "support/text/html.h"

namespace seamline {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string hostile =
    std::string("a\x1b[31mb\0c\x7f\n\r\t", 13) + "\xFF\xC3(\xED\xA0\x80" + "\xE2\x80\xAE" + "d";

TEST(Printable, LettersOfEveryScriptStay) {
  for (const std::string text : {"Mondlandschaft, größer", "Плотность тени", "視差の研究", "دراسة الظل",
                                 "छाया क्षेत्र", "می‌خواهم", "👩‍🔬 €", "ß", ""}) {
    EXPECT_EQ(printable(text), text);
    EXPECT_EQ(clean_text(text), text);
    EXPECT_TRUE(is_utf8(text));
  }
}

TEST(Printable, WhatCannotBeShownIsWrittenOut) {
  EXPECT_EQ(printable(hostile), "a\\x1B[31mb\\x00c\\x7F\\n\\r\\t\\xFF\\xC3(\\xED\\xA0\\x80\\u{202E}d");
  EXPECT_EQ(clean_text(std::string("a\x1b\0\n\xFF", 5)), "a\xEF\xBF\xBD\xEF\xBF\xBD\n\xEF\xBF\xBD");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\u{009B}31m");  // what a terminal takes for an escape
  EXPECT_FALSE(is_utf8(hostile));
}

TEST(Printable, ALongTextKeepsItsBeginningAndEnd) {
  const std::string text = "begin" + std::string(5'000'000, 'x') + "end";
  EXPECT_THAT(printable(text),
              testing::AllOf(StartsWith("beginx"), HasSubstr("[... 4999708 bytes ...]"), EndsWith("xend")));
  EXPECT_LE(printable(text, 50).size(), 80U);
  EXPECT_EQ(printable(std::string(300, 'x')), std::string(300, 'x'));
  std::string many;
  for (int i = 0; i < 400; ++i) many += "視";
  EXPECT_TRUE(is_utf8(printable(many)));
  EXPECT_THAT(printable(many), HasSubstr("[... 300 bytes ...]"));
}

TEST(Printable, AnyBytesBecomeOneLineOfUtf8) {
  Random random(7);
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    const auto size = random.below(60);
    for (std::uint64_t k = 0; k < size; ++k)
      text += static_cast<char>(random.below(4) == 0 ? random.below(128) : 128 + random.below(128));
    const std::string line = printable(text, 20);
    ASSERT_TRUE(is_utf8(line));
    for (const char c : line) ASSERT_GE(static_cast<unsigned char>(c), 0x20);
    ASSERT_EQ(printable(line, 1000), line);
    ASSERT_TRUE(is_utf8(clean_text(text)));
  }
}

TEST(Printable, ComplaintsAreOneShortLine) {
  const std::string sentence =
      input_error(
          {.file = hostile, .field = hostile, .wanted = "x", .found = hostile + std::string(5'000'000, 'y')})
          .what();
  EXPECT_LT(sentence.size(), 1500U);
  EXPECT_EQ(sentence, printable(sentence, 5000));
  EXPECT_TRUE(is_utf8(sentence));
}

TEST(Printable, PagesTablesAndFiguresHoldNothingElse) {
  const std::string huge = hostile + std::string(5'000'000, 'y');
  const CsvTable table{.name = "t", .columns = {{"a", "", ""}}, .rows = {{huge}}};
  for (const std::string& text : {html_escape(huge), csv_text(table), gnuplot_text(huge)}) {
    EXPECT_TRUE(is_utf8(text));
    EXPECT_LT(text.size(), 50'000U);
    for (const char c : {'\x1b', '\0', '\x7f'}) EXPECT_EQ(text.find(c), std::string::npos);
  }
  EXPECT_EQ(html_escape("視 < \"Ω\""), "視 &lt; &quot;Ω&quot;");
  EXPECT_EQ(gnuplot_text("視 Ω"), "視 Ω");
}

}  // namespace
}  // namespace seamline
