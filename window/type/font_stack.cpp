#include "window/type/font_stack.h"

#include <algorithm>

namespace seamline::inline window {
namespace {

std::size_t font_of_cluster(const FontStack& fonts, std::u32string_view cluster) {
  std::size_t first = fonts.size();
  for (std::size_t i = 0; i < fonts.size(); ++i) {
    if (!fonts[i].shaping.has(cluster.front())) continue;
    if (std::all_of(cluster.begin(), cluster.end(), [&](char32_t c) { return fonts[i].shaping.has(c); }))
      return i;
    first = std::min(first, i);
  }
  return first == fonts.size() ? 0 : first;
}

}  // namespace

std::vector<std::size_t> fonts_of(const FontStack& fonts, std::u32string_view text) {
  std::vector<std::size_t> chosen;
  chosen.reserve(text.size());
  while (chosen.size() < text.size()) {
    const std::size_t begin = chosen.size();
    std::size_t end = begin + 1;
    while (end < text.size() && is_joined_to_previous(text[end])) ++end;
    chosen.resize(end, font_of_cluster(fonts, text.substr(begin, end - begin)));
  }
  return chosen;
}

std::u32string missing_characters(const FontStack& fonts, std::u32string_view text) {
  std::u32string missing;
  for (const char32_t character : text)
    if (missing.find(character) == std::u32string::npos &&
        std::none_of(fonts.begin(), fonts.end(), [&](const TypeFont& f) { return f.shaping.has(character); }))
      missing += character;
  return missing;
}

}  // namespace seamline::inline window
