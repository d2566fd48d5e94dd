// The only file that includes FriBidi.
#include "window/type/text_direction.h"

#include <fribidi.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <new>
#include <numeric>
#include <string>

namespace seamline::inline window {

bool runs_right_to_left(std::string_view language) {
  constexpr std::array<std::string_view, 15> right_to_left = {
      "ar", "arc", "ckb", "dv", "fa", "he", "iw", "ks", "nqo", "ps", "sd", "syr", "ug", "ur", "yi"};
  std::string tag;
  for (const char letter : language)
    tag += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  const auto has_part = [&](const char* part) { return ("-" + tag + "-").find(part) != std::string::npos; };
  if (has_part("-arab-") || has_part("-hebr-")) return true;
  if (has_part("-latn-") || has_part("-cyrl-")) return false;
  return std::find(right_to_left.begin(), right_to_left.end(), tag.substr(0, tag.find('-'))) !=
         right_to_left.end();
}

std::vector<std::uint8_t> direction_levels(std::u32string_view paragraph, bool right_to_left) {
  const auto count = static_cast<FriBidiStrIndex>(paragraph.size());
  if (count == 0) return {};
  const std::vector<FriBidiChar> characters(paragraph.begin(), paragraph.end());
  std::vector<FriBidiCharType> types(paragraph.size());
  std::vector<FriBidiBracketType> brackets(paragraph.size());
  std::vector<FriBidiLevel> levels(paragraph.size());
  fribidi_get_bidi_types(characters.data(), count, types.data());
  fribidi_get_bracket_types(characters.data(), count, types.data(), brackets.data());
  FriBidiParType base = right_to_left ? FRIBIDI_PAR_RTL : FRIBIDI_PAR_LTR;
  if (fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), count, &base, levels.data()) == 0)
    throw std::bad_alloc();
  return {levels.begin(), levels.end()};
}

std::vector<std::size_t> order_on_line(const std::vector<std::uint8_t>& levels) {
  std::vector<std::size_t> order(levels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (levels.empty()) return order;
  for (int level = *std::max_element(levels.begin(), levels.end()); level > 0; --level)
    for (std::size_t begin = 0; begin < levels.size(); ++begin) {
      std::size_t end = begin;
      while (end < levels.size() && levels[order[end]] >= level) ++end;
      std::reverse(order.begin() + begin, order.begin() + end);
      begin = end;
    }
  return order;
}

}  // namespace seamline::inline window
