#pragma once
#include <memory>
#include <string>
#include <vector>

namespace seamline {

/// A regular expression (ECMAScript). The library's own is compiled in one file: it takes seconds in each.
class Pattern {
 public:
  enum class Case { matters, any };

  explicit Pattern(const std::string& expression, Case letters = Case::matters);

  /// Whether it describes the whole text.
  [[nodiscard]] bool matches(const std::string& text) const;
  /// Whether it describes a part of the text.
  [[nodiscard]] bool is_in(const std::string& text) const;
  /// The whole text, then what each pair of brackets describes; empty where it does not match.
  [[nodiscard]] std::vector<std::string> parts(const std::string& text) const;

 private:
  struct Compiled;
  std::shared_ptr<const Compiled> compiled_;
};

}  // namespace seamline
