#include "window/characters.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "support/text/error.h"

namespace seamline::inline window {
namespace {

constexpr char32_t no_character = 0xFFFD;

/// How many bytes a character has that begins with this one; 0: it cannot begin with it.
int length_of(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  if (first >= 0xF0 && first < 0xF5) return 4;
  return 0;
}

struct Range {
  char32_t first, last;
};

constexpr std::array<Range, 8> shaped = {{
    {0x0300, 0x036F},  // combining marks
    {0x0590, 0x08FF},  // Hebrew, Arabic, Syriac, Thaana, N'Ko
    {0x0900, 0x0DFF},  // Devanagari to Sinhala
    {0x0E31, 0x109F},  // Thai marks, Lao, Tibetan, Myanmar
    {0x1780, 0x18AF},  // Khmer, Mongolian
    {0x1900, 0x1CFF},  // Limbu to Vedic extensions
    {0xFB1D, 0xFDFF},  // presentation forms
    {0xFE70, 0xFEFE},
}};

}  // namespace

std::u32string characters_of(std::string_view utf8) {
  std::u32string characters;
  for (std::size_t at = 0; at < utf8.size();) {
    const auto first = static_cast<unsigned char>(utf8[at]);
    const int length = length_of(first);
    if (length == 0 || at + static_cast<std::size_t>(length) > utf8.size()) {
      characters.push_back(no_character);
      ++at;
      continue;
    }
    char32_t character = length == 1 ? first : first & (0xFFU >> (length + 1));
    bool whole = true;
    for (int i = 1; i < length; ++i) {
      const auto next = static_cast<unsigned char>(utf8[at + static_cast<std::size_t>(i)]);
      whole = whole && (next & 0xC0U) == 0x80U;
      character = (character << 6U) | (next & 0x3FU);
    }
    characters.push_back(whole ? character : no_character);
    at += whole ? static_cast<std::size_t>(length) : 1;
  }
  return characters;
}

bool needs_shaping(char32_t character) {
  return std::any_of(shaped.begin(), shaped.end(), [character](const Range& range) {
    return character >= range.first && character <= range.last;
  });
}

void refuse_text_that_needs_shaping(const std::string& file, const std::string& field,
                                    std::string_view text) {
  for (const char32_t character : characters_of(text))
    if (needs_shaping(character))
      throw input_error({.file = file,
                         .field = field,
                         .wanted = "a script that is set one letter after the other (instructions in others "
                                   "can be pictures)",
                         .found = fmt::format("U+{:04X}", static_cast<unsigned>(character))});
}

}  // namespace seamline::inline window
