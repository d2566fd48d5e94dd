// The only file that includes libunibreak and libthai.
#include "window/type/line_breaks.h"

#include <linebreak.h>

#include <mutex>
#ifdef SEAMLINE_HAS_THAI
#include <thai/thwbrk.h>

#include <memory>
#endif

namespace seamline::inline window {
namespace {

#ifdef SEAMLINE_HAS_THAI
bool is_thai(char32_t character) {
  return character >= 0x0E00 && character <= 0x0E7F;
}

/// Thai has no spaces between words; a dictionary knows them.
void add_thai_breaks(std::u32string_view paragraph, std::vector<bool>& may_end) {
  static std::mutex one_at_a_time;
  static const std::unique_ptr<ThBrk, decltype(&th_brk_delete)> dictionary{th_brk_new(nullptr),
                                                                           &th_brk_delete};
  if (!dictionary) return;
  const std::lock_guard lock(one_at_a_time);
  for (std::size_t begin = 0; begin < paragraph.size(); ++begin) {
    std::size_t end = begin;
    while (end < paragraph.size() && is_thai(paragraph[end])) ++end;
    if (end == begin) continue;
    const std::wstring words(paragraph.begin() + begin, paragraph.begin() + end);
    std::vector<int> starts(words.size());
    const int count = th_brk_wc_find_breaks(dictionary.get(), words.c_str(), starts.data(), starts.size());
    for (int i = 0; i < count; ++i)
      if (const std::size_t start = starts[i]; start > 0) may_end[begin + start - 1] = true;
    begin = end;
  }
}
#endif

}  // namespace

std::vector<bool> line_may_end(std::u32string_view paragraph, const std::string& language) {
  static std::once_flag ready;
  std::call_once(ready, init_linebreak);
  const std::vector<utf32_t> characters(paragraph.begin(), paragraph.end());
  std::vector<char> breaks(paragraph.size());
  set_linebreaks_utf32(characters.data(), characters.size(), language.substr(0, language.find('-')).c_str(),
                       breaks.data());
  std::vector<bool> may_end;
  may_end.reserve(breaks.size());
  for (const char kind : breaks)
    may_end.push_back(kind == LINEBREAK_ALLOWBREAK || kind == LINEBREAK_MUSTBREAK);
#ifdef SEAMLINE_HAS_THAI
  add_thai_breaks(paragraph, may_end);
#endif
  return may_end;
}

}  // namespace seamline::inline window
