#include "support/text/text_bounds.h"

#include <algorithm>
#include <cstdint>

#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline {
namespace {

InputError too_deep(std::string_view text, std::size_t at, const std::string& file) {
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return input_error({.file = file,
                      .field = "line " + std::to_string(line),
                      .wanted = "at most " + std::to_string(limits::deepest_text_nesting) +
                                " levels of tables, objects or arrays",
                      .found = "more"});
}

InputError too_many(const std::string& file) {
  return input_error({.file = file,
                      .wanted = "at most " + std::to_string(limits::most_text_values) + " values",
                      .found = "more"});
}

/// First place after the string that opens at `begin`; the text's end when it is not closed.
std::size_t after_string(std::string_view text, std::size_t begin, std::string_view quote, bool escapes) {
  for (std::size_t at = begin + quote.size(); at < text.size(); ++at) {
    if (escapes && text[at] == '\\')
      ++at;
    else if (text.substr(at).starts_with(quote))
      return at + quote.size();
  }
  return text.size();
}

std::size_t after_toml_string(std::string_view text, std::size_t begin) {
  const std::string_view rest = text.substr(begin);
  for (const std::string_view quote : {"\"\"\"", "'''", "\"", "'"})
    if (rest.starts_with(quote)) return after_string(text, begin, quote, quote.front() == '"');
  return begin + 1;
}

}  // namespace

void require_bounded_json(std::string_view text, const std::string& file) {
  int depth = 0;
  std::int64_t values = 1;
  for (std::size_t at = 0; at < text.size();) {
    const char letter = text[at];
    if (letter == '"') {
      at = after_string(text, at, "\"", true);
      continue;
    }
    if (letter == '{' || letter == '[') ++depth;
    if (letter == '}' || letter == ']') --depth;
    if (letter == ',' || letter == '{' || letter == '[') ++values;
    if (depth > limits::deepest_text_nesting) throw too_deep(text, at, file);
    if (values > limits::most_text_values) throw too_many(file);
    ++at;
  }
}

void require_bounded_toml(std::string_view text, const std::string& file) {
  int depth = 0;  // of brackets
  int dots = 0;   // in the key or number at hand
  std::int64_t values = 1;
  for (std::size_t at = 0; at < text.size();) {
    const char letter = text[at];
    if (letter == '"' || letter == '\'') {
      at = after_toml_string(text, at);
      continue;
    }
    if (letter == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (letter == '{' || letter == '[') ++depth;
    if (letter == '}' || letter == ']') depth = std::max(depth - 1, 0);
    if (letter == '.') ++dots;
    if (std::string_view("=,{}\n").find(letter) != std::string_view::npos) dots = 0;
    if (std::string_view("=,{[.").find(letter) != std::string_view::npos) ++values;
    if (depth + dots > limits::deepest_text_nesting) throw too_deep(text, at, file);
    if (values > limits::most_text_values) throw too_many(file);
    ++at;
  }
}

}  // namespace seamline
