#include "window/type/characters.h"

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

std::vector<std::u32string> lines_of(std::string_view utf8) {
  std::vector<std::u32string> lines(1);
  for (const char32_t character : characters_of(utf8)) {
    if (character == U'\n')
      lines.emplace_back();
    else if (character != U'\r')
      lines.back() += character < U' ' ? U' ' : character;
  }
  return lines;
}

}  // namespace seamline::inline window
