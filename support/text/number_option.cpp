#include "support/text/number_option.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "support/text/error.h"

namespace seamline {
namespace {

/// "+1" is a number to people, and was one to this program.
std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text.front() == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  text = without_plus(text);
  Number value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

bool is_whole_inside(const std::string& text, NumberRange range) {
  const std::optional<std::int64_t> value = number_in<std::int64_t>(text);
  if (value) return inside(static_cast<double>(*value), range);
  return range.most >= any_seed.most && number_in<std::uint64_t>(text);
}

bool is_decimal_inside(const std::string& text, NumberRange range) {
  const std::optional<double> value = decimal_number(text);
  return value && inside(*value, range);
}

std::string range_words(NumberRange range) {
  const std::string from = " from ", text = range_text("", range);
  return text.starts_with(from) ? text.substr(from.size()) : text;
}

std::string field_of(const CLI::Option& option) {
  return (option.get_positional() ? "" : "--") + option.get_single_name();
}

}  // namespace

std::optional<double> decimal_number(std::string_view text) {
  const std::optional<double> value = number_in<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::pair<int, int>> whole_pair(std::string_view text, char between) {
  const std::size_t at = text.find(between);
  if (at == std::string_view::npos || text.find_first_not_of("0123456789") != at) return std::nullopt;
  const std::optional<int> first = number_in<int>(text.substr(0, at)),
                           second = number_in<int>(text.substr(at + 1));
  if (!first || !second || *second < 0) return std::nullopt;
  return std::pair{*first, *second};
}

void number_option::check_numbers(CLI::Option& option, NumberRange range, bool whole) {
  const std::string field = field_of(option);
  const int numbers = option.get_items_expected_min();
  option.type_name(whole ? "INTEGER" : "NUMBER");
  option.check(CLI::Validator(
      [field, range, whole, numbers](std::string& text) {
        if (numbers > 1 && text.starts_with("--"))  // CLI11 takes the next option for a number
          throw input_error({.field = field,
                             .wanted = fmt::format("{} numbers", numbers),
                             .found = "\"" + text + "\" after fewer"});
        if (!(whole ? is_whole_inside(text, range) : is_decimal_inside(text, range)))
          throw input_error({.field = field,
                             .wanted = range_text(whole ? "a whole number" : "a number", range),
                             .found = "\"" + text + "\""});
        return std::string();
      },
      range_words(range)));
}

CLI::Option* add_formed_text(CLI::App& command, const std::string& name, std::string& target,
                             const std::string& form, const std::string& description,
                             const std::function<void(const std::string&)>& check) {
  return command.add_option(name, target, description)
      ->type_name(form)
      ->check(CLI::Validator(
          [check](std::string& text) {
            check(text);
            return std::string();
          },
          ""));
}

}  // namespace seamline
