#pragma once
#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stimuli/definition/axis.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

using Range = NumberRange;

/// The words that a key may hold, and what each means.
template <class Value>
using Words = std::vector<std::pair<std::string_view, Value>>;

/// The value that the text at `key` names, `fallback` when there is none.
template <class Value>
Value one_of(const TomlTable& table, const char* key, Value fallback, const Words<Value>& words) {
  if (!table.has(key)) return fallback;
  const std::string text = table.text(key);
  std::string wanted;
  for (const auto& [word, value] : words) {
    if (word == text) return value;
    wanted += fmt::format("{}\"{}\"", wanted.empty() ? "" : " or ", word);
  }
  throw table.complaint(key, wanted, "\"" + text + "\"");
}

/// `noticeability`: whether it "falls" with the level or "rises".
inline Direction read_direction(const TomlTable& table, Direction fallback) {
  return one_of<Direction>(table, "noticeability", fallback,
                           {{"falls", Direction::decreasing}, {"rises", Direction::increasing}});
}

}  // namespace seamline::inline stimuli
