#pragma once
#include <CLI/CLI.hpp>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/text/limits.h"
#include "support/text/number_range.h"

namespace seamline {

// The one checker of numbers on the command line: what is no number of its option's range ends the command
// before anything is done. `seamline --list-options` lists every option of every command, and a test tries
// wrong numbers on all of them; an option that holds a number in another way does not pass it.

inline constexpr NumberRange any_seed{0, 18446744073709551615.0};
/// Places, as in study files.
inline constexpr NumberRange any_place_m{-limits::farthest_place_m, limits::farthest_place_m, "m"};

/// The finite decimal number that a text is, with nothing before or after it.
[[nodiscard]] std::optional<double> decimal_number(std::string_view text);

/// Two whole numbers that are not negative, with one letter between: "480x270".
[[nodiscard]] std::optional<std::pair<int, int>> whole_pair(std::string_view text, char between);

namespace number_option {

template <class Target>
struct NumberIn {
  using Type = Target;
};
template <class Number>
struct NumberIn<std::optional<Number>> {
  using Type = Number;
};
template <class Number>
struct NumberIn<std::vector<Number>> {
  using Type = Number;
};
template <class Number, std::size_t size>
struct NumberIn<std::array<Number, size>> {
  using Type = Number;
};

template <class Target>
inline constexpr bool is_array = false;
template <class Number, std::size_t size>
inline constexpr bool is_array<std::array<Number, size>> = true;

void check_numbers(CLI::Option& option, NumberRange range, bool whole);

}  // namespace number_option

/// An option whose values are numbers: `target` is a number, or an optional, array or vector of them.
template <class Target>
CLI::Option* add_number(CLI::App& command, const std::string& name, Target& target, NumberRange range,
                        const std::string& description) {
  using Number = typename number_option::NumberIn<Target>::Type;
  static_assert(std::is_arithmetic_v<Number>);
  CLI::Option* option = command.add_option(name, target, description);
  number_option::check_numbers(*option, range, std::is_integral_v<Number>);
  if constexpr (number_option::is_array<Target>) option->delimiter(',');  // "0,-1,-3" as well as "0 -1 -3"
  return option;
}

/// An option whose text is made of numbers. `form` stands for it in --help, e.g. "WxH"; `check` throws
/// InputError at a text that is not like that.
CLI::Option* add_formed_text(CLI::App& command, const std::string& name, std::string& target,
                             const std::string& form, const std::string& description,
                             const std::function<void(const std::string&)>& check);

}  // namespace seamline
