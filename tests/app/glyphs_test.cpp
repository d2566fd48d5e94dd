// Fonts from outside: shapes where they are right, one sentence where they are not.
#include "window/type/glyphs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "small_font.h"
#include "support/arithmetic/random.h"
#include "support/text/error.h"
#include "tests/complaint.h"
#include "window/type/open_fonts.h"
#include "window/type/paragraph.h"

namespace seamline::study::app {
namespace {

using testing::HasSubstr;

seamline::FontBytes bytes_of_font(const std::string& bytes, const std::string& file) {
  return {std::make_shared<const std::string>(bytes), file, false};
}

int covered(const Coverage& glyph) {
  return std::accumulate(glyph.values.begin(), glyph.values.end(), 0);
}

TEST(Glyphs, AreTheShapesOfTheFont) {
  const OutlineFont font(bytes_of_font(test::small_font(), "small.ttf"));
  EXPECT_DOUBLE_EQ(font.ascent_em(), 0.8);
  EXPECT_DOUBLE_EQ(font.height_em(), 1);
  EXPECT_EQ(font.glyph(1, 100, 0).values.size(), 0U);  // the space
  const Coverage a = font.glyph(2, 100, 0);
  EXPECT_EQ(a.width_px, 70);
  EXPECT_EQ(a.height_px, 70);
  EXPECT_EQ(a.left_px, 0);
  EXPECT_EQ(a.top_px, -70);
  EXPECT_EQ(covered(a), 70 * 70 * 255);
  EXPECT_EQ(covered(font.glyph(3, 100, 0)), 50 * 50 * 255);
  EXPECT_EQ(font.glyph(4, 100, 0).width_px, 70);
  const Coverage moved = font.glyph(2, 100, 0.5);
  EXPECT_EQ(moved.width_px, 71);
  EXPECT_NEAR(moved.values.front(), 128, 1);
  EXPECT_EQ(font.frame(2, 100, 0.5).width_px, 71);
}

TEST(Glyphs, OfALineStandOnItsFootAndGoOnByTheirWidths) {
  FontStack fonts;
  fonts.emplace_back(bytes_of_font(test::small_font(), "small.ttf"));
  const TypeStyle style{.fonts = &fonts, .size_px = 100};
  const ArrangedText text = arrange(style, "AB", 0);
  ASSERT_EQ(text.lines.size(), 1U);
  EXPECT_EQ(text.width_px, 160);
  EXPECT_EQ(text.height_px, 100);
  const Coverage line = draw_line(style, text.lines[0], 1000);
  EXPECT_EQ(line.left_px, 0);
  EXPECT_EQ(line.top_px, 10);  // 80 px above the letters' foot the line begins
  EXPECT_EQ(line.width_px, 80 + 50);
  EXPECT_EQ(covered(line), (70 * 70 + 50 * 50) * 255);
  EXPECT_EQ(draw_line(style, text.lines[0], 100).width_px, 100);
}

TEST(Glyphs, OfAnotherFileAreOneSentence) {
  const auto complaint = [](const std::string& bytes) {
    return test::complaint_of([&] { const OutlineFont font(bytes_of_font(bytes, "session.ttf")); });
  };
  for (const std::string& bytes : {std::string(), std::string("wOFF"), std::string("%!PS-AdobeFont"),
                                   std::string(1000, '\0'), std::string("\x89PNG\r\n\x1a\n")})
    EXPECT_THAT(complaint(bytes), HasSubstr("session.ttf: font: wanted a TrueType or OpenType font, found"));
  EXPECT_THAT(complaint(std::string("\0\1\0\0", 4)), HasSubstr("found a damaged one"));
  for (std::size_t length = 0; length < 300; length += 7)
    EXPECT_THAT(complaint(test::small_font().substr(0, length)), HasSubstr("wanted a TrueType"));
}

TEST(Glyphs, OfFontsWithAnyByteChangedAreSoundOrRefused) {
  const std::string font = test::small_font();
  Random random(19);
  int opened = 0, refused = 0;
  for (std::size_t at = 0; at < font.size(); ++at)
    for (int change = 0; change < 4; ++change) {
      std::string damaged = font;
      damaged[at] = static_cast<char>(change == 0 ? 255 : change == 1 ? 128 : random.below(256));
      try {
        FontStack fonts;
        fonts.emplace_back(bytes_of_font(damaged, "damaged.ttf"));
        const TypeStyle style{.fonts = &fonts, .size_px = 22};
        for (const TextLine& line : arrange(style, "ABC CBA", 60).lines) {
          const Coverage drawn = draw_line(style, line, 300);
          EXPECT_EQ(drawn.values.size(), static_cast<std::size_t>(drawn.width_px * drawn.height_px));
          EXPECT_LE(drawn.width_px, 300 + 22);
          EXPECT_GE(line.width_px, 0);
        }
        ++opened;
      } catch (const InputError&) {
        ++refused;
      }
    }
  EXPECT_GT(opened, 100);
  EXPECT_GT(refused, 100);
}

TEST(Glyphs, OfCharactersWithoutAFontAreRefusedWithTheirScriptAndAPackage) {
  FontStack fonts;
  fonts.emplace_back(bytes_of_font(test::small_font(), "small.ttf"));
  const auto complaint = [&](const char* text) {
    return test::complaint_of([&] { require_shapes({.fonts = &fonts}, text); });
  };
  EXPECT_EQ(complaint("ABC\nCAB\u200d"), "no complaint");
  EXPECT_THAT(complaint("A हिन्दी"), HasSubstr("Devanagari letters: Debian's fonts-lohit-deva"));
  EXPECT_THAT(complaint("ที่"), HasSubstr("Thai letters: Debian's fonts-tlwg-loma-ttf"));
  EXPECT_THAT(complaint("日本"), HasSubstr("Chinese letters: Debian's fonts-noto-cjk"));
  EXPECT_THAT(complaint("A é"), HasSubstr("none with U+00E9"));
}

}  // namespace
}  // namespace seamline::study::app
