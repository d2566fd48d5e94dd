// Fonts from outside: shapes where they are right, one sentence where they are not.
#include "window/glyphs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "small_font.h"
#include "support/arithmetic/random.h"
#include "support/text/error.h"
#include "tests/complaint.h"

namespace seamline::study::app {
namespace {

using testing::HasSubstr;

int covered(const Glyph& glyph) {
  return std::accumulate(glyph.coverage.begin(), glyph.coverage.end(), 0);
}

TEST(Glyphs, AreTheShapesOfTheFont) {
  const std::vector<Glyph> glyphs = glyphs_of(test::small_font(), "small.ttf", U"CBA AX", 100);
  ASSERT_EQ(glyphs.size(), 4U);
  const std::u32string order = U" ABC";
  for (std::size_t i = 0; i < glyphs.size(); ++i) {
    EXPECT_EQ(glyphs[i].character, order[i]);
    EXPECT_EQ(glyphs[i].advance_px, 80);
  }
  EXPECT_EQ(glyphs[0].coverage.size(), 0U);
  EXPECT_EQ(glyphs[1].width_px, 70);
  EXPECT_EQ(glyphs[1].height_px, 70);
  EXPECT_EQ(glyphs[1].left_px, 0);
  EXPECT_EQ(glyphs[1].top_px, 10);  // the line is 80 px above the letter's foot
  EXPECT_EQ(covered(glyphs[1]), 70 * 70 * 255);
  EXPECT_EQ(covered(glyphs[2]), 50 * 50 * 255);
  EXPECT_EQ(glyphs[3].width_px, 70);
}

TEST(Glyphs, OfAnotherFileAreOneSentence) {
  const auto complaint = [](const std::string& bytes) {
    return test::complaint_of([&] { (void)glyphs_of(bytes, "session.ttf", U"AB", 22); });
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
        for (const Glyph& glyph : glyphs_of(damaged, "damaged.ttf", U" ABC", 22)) {
          EXPECT_EQ(glyph.coverage.size(), static_cast<std::size_t>(glyph.width_px * glyph.height_px));
          EXPECT_LE(std::max(glyph.width_px, glyph.height_px), 2 * largest_shape_em * 22 + 2);
          EXPECT_GE(glyph.advance_px, 0);
        }
        ++opened;
      } catch (const InputError&) {
        ++refused;
      }
    }
  EXPECT_GT(opened, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace seamline::study::app
