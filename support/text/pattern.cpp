#include "support/text/pattern.h"

#include <regex>

namespace seamline {

struct Pattern::Compiled {
  std::regex expression;
};

Pattern::Pattern(const std::string& expression, Case letters)
    : compiled_(std::make_shared<const Compiled>(
          Compiled{std::regex(expression, letters == Case::any ? std::regex::ECMAScript | std::regex::icase
                                                               : std::regex::ECMAScript)})) {}

bool Pattern::matches(const std::string& text) const {
  return std::regex_match(text, compiled_->expression);
}

bool Pattern::is_in(const std::string& text) const {
  return std::regex_search(text, compiled_->expression);
}

std::vector<std::string> Pattern::parts(const std::string& text) const {
  std::smatch found;
  if (!std::regex_match(text, found, compiled_->expression)) return {};
  return {found.begin(), found.end()};
}

}  // namespace seamline
