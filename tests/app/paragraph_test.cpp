// Paragraphs of several scripts: ordered, broken and shaped as Pango does it (tests/data/paragraphs.py).
#include "window/type/paragraph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/files/atomic_file.h"
#include "window/type/line_breaks.h"
#include "window/type/open_fonts.h"
#include "window/type/text_direction.h"

namespace seamline::study::app {
namespace {

using testing::ElementsAre;

const std::vector<std::string> families = {"DejaVu Sans", "Lohit Devanagari", "Loma"};
constexpr std::uint32_t space_number = 3;  // in all of these fonts

/// The fonts that Pango had.
const FontStack& fonts_of_debian() {
  static const FontStack fonts = [] {
    std::vector<FontFiles> files;
    for (const char* file :
         {"dejavu/DejaVuSans.ttf", "lohit-devanagari/Lohit-Devanagari.ttf", "tlwg/Loma.ttf"})
      files.push_back({std::filesystem::path("/usr/share/fonts/truetype") / file, {}, false});
    return open_fonts(files, &FontFiles::text);
  }();
  return fonts;
}

TypeStyle style_of(const std::string& language) {
  return {.fonts = &fonts_of_debian(),
          .size_px = 22,
          .language = language,
          .right_to_left = runs_right_to_left(language)};
}

using NamedGlyph = std::pair<std::string, std::uint32_t>;

std::vector<NamedGlyph> letters_of(const TextLine& line) {
  std::vector<NamedGlyph> letters;
  for (const PlacedGlyph& glyph : line.glyphs)
    if (glyph.number != space_number) letters.emplace_back(families.at(glyph.font), glyph.number);
  return letters;
}

TEST(Paragraphs, HavePangosLinesShapesAndOrder) {
  const auto facts = nlohmann::json::parse(
      read_file(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "tests/data/paragraphs.json"));
  ASSERT_EQ(facts["paragraphs"].size(), 6U);
  for (const auto& fact : facts["paragraphs"]) {
    const std::string text = fact["text"];
    const ArrangedText arranged = arrange(style_of(fact["language"]), text, fact["width_px"]);
    ASSERT_EQ(arranged.lines.size(), fact["lines"].size()) << text;
    for (std::size_t i = 0; i < arranged.lines.size(); ++i)
      EXPECT_EQ(letters_of(arranged.lines[i]), fact["lines"][i]["glyphs"].get<std::vector<NamedGlyph>>())
          << fact["lines"][i]["text"];
  }
}

/// What hb-shape 6.0.0 says of words alone.
TEST(Paragraphs, HaveHarfBuzzsGlyphsAndAdvances) {
  const auto numbers = [](const std::string& language, const char* word) {
    const ArrangedText text = arrange(style_of(language), word, 0);
    std::vector<std::uint32_t> found;
    for (const PlacedGlyph& glyph : text.lines.at(0).glyphs) found.push_back(glyph.number);
    return found;
  };
  EXPECT_THAT(numbers("ar", "أوافق"), ElementsAre(5328, 5325, 1365, 1393, 1361));
  EXPECT_THAT(numbers("ar", "السلام"), ElementsAre(1390, 5366, 5294, 5337, 1365));  // lam and alef are one
  EXPECT_THAT(numbers("hi", "हिन्दी"), ElementsAre(368, 362, 541, 343, 369));        // the vowel comes first
  EXPECT_THAT(numbers("hi", "क्षत्रिय"), ElementsAre(520, 368, 593, 352));
  EXPECT_THAT(numbers("th", "ที่นี่น้ำ"), ElementsAre(228, 258, 273, 230, 258, 273, 230, 278, 274, 255));
  EXPECT_THAT(numbers("he", "שלום"), ElementsAre(1332, 1324, 1331, 1344));
  const ArrangedText arabic = arrange(style_of("ar"), "أوافق", 0);
  EXPECT_NEAR(arabic.width_px, (1708 + 979 + 569 + 989 + 569) / 2048.0 * style_of("ar").em_px(), 0.02);
}

TEST(Paragraphs, OfRightToLeftLanguagesStandAtTheRight) {
  const char* text = "أنت مدعو للمشاركة في دراسة حول كيفية رؤية الناس للصور.";
  for (const double wrap_px : {120.0, 200.0, 333.0}) {
    const ArrangedText arabic = arrange(style_of("ar"), text, wrap_px);
    ASSERT_GT(arabic.lines.size(), 1U);
    for (const TextLine& line : arabic.lines) {
      EXPECT_LE(line.width_px, wrap_px);
      EXPECT_NEAR(line.left_px + line.width_px, wrap_px, 0.5);
    }
    const ArrangedText english = arrange(style_of("en"), text, wrap_px);
    for (const TextLine& line : english.lines) EXPECT_EQ(line.left_px, 0);
  }
}

TEST(Paragraphs, KeepEveryCharacterWhateverTheWidth) {
  const std::string text = "Ein Donaudampfschifffahrtsgesellschaftskapitän  sagte: 日本語の文章\n\nEnde";
  for (const double wrap_px : {0.0, 1.0, 30.0, 90.0, 5000.0}) {
    std::size_t letters = 0;
    const ArrangedText broken = arrange(style_of("de"), text, wrap_px);
    for (const TextLine& line : broken.lines) letters += letters_of(line).size();
    EXPECT_EQ(letters, letters_of(arrange(style_of("de"),
                                          "EinDonaudampfschifffahrtsgesellschaftskapitän"
                                          "sagte:日本語の文章Ende",
                                          0)
                                      .lines.at(0))
                           .size())
        << wrap_px;
  }
  EXPECT_EQ(arrange(style_of("de"), "", 100).lines.size(), 1U);
  EXPECT_EQ(arrange(style_of("de"), "a\nb\n", 100).lines.size(), 3U);
}

TEST(TextDirection, OfATagIsThatOfThePageInABrowser) {
  for (const char* tag : {"ar", "AR-eg", "he", "fa", "ur-PK", "az-Arab", "yi"})
    EXPECT_TRUE(runs_right_to_left(tag)) << tag;
  for (const char* tag : {"", "en", "hi", "th", "ar-Latn", "arn", "zh-Hant"})
    EXPECT_FALSE(runs_right_to_left(tag)) << tag;
}

/// Rule L2 of UAX #9, on its own example: levels of "car MEANS CAR" within a line from right to left.
TEST(TextDirection, PartsAreReversedFromTheHighestLevelDown) {
  EXPECT_THAT(order_on_line({0, 1, 0}), ElementsAre(0, 1, 2));
  EXPECT_THAT(order_on_line({1, 2, 1}), ElementsAre(2, 1, 0));
  EXPECT_THAT(order_on_line({0, 1, 2, 1, 0}), ElementsAre(0, 3, 2, 1, 4));
  EXPECT_THAT(order_on_line({2, 2, 1, 0, 3}), ElementsAre(2, 0, 1, 3, 4));
  EXPECT_TRUE(order_on_line({}).empty());
}

TEST(LineBreaks, OfThaiStandBetweenWords) {
  const std::u32string text = U"ภาพมีวัตถุ";  // picture, has, object
  std::vector<std::size_t> ends;
  const std::vector<bool> may_end = line_may_end(text, "th");
  for (std::size_t i = 0; i < may_end.size(); ++i)
    if (may_end[i]) ends.push_back(i + 1);
  EXPECT_THAT(ends, ElementsAre(3, 5, 10));
}

}  // namespace
}  // namespace seamline::study::app
