#pragma once
#include <string>
#include <string_view>

namespace seamline {

/// A word of the shell, whatever it holds.
[[nodiscard]] inline std::string shell_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// The same, without quotes where none are needed.
[[nodiscard]] inline std::string shell_word(const std::string& text) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  const bool is_plain = !text.empty() && text.find_first_not_of(plain) == std::string::npos;
  return is_plain ? text : shell_quoted(text);
}

}  // namespace seamline
