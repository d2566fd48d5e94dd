#pragma once
#include <array>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "stimuli/definition/depth_chain.h"
#include "stimuli/settings/setting.h"
#include "support/text/number_option.h"

// Options of commands that take what a study file can say: words, ranges and units are the row's.
namespace seamline::inline stimuli {

/// An option for a setting that is a number.
template <class Owner>
CLI::Option* add_setting(CLI::App& command, const std::string& name, std::string_view key, Owner& owner,
                         const std::string& description) {
  const Setting<Owner>& row = setting<Owner>(key);
  if (const auto* whole = std::get_if<int Owner::*>(&row.slot))
    return add_number(command, name, owner.**whole, row.range, description)->capture_default_str();
  return add_number(command, name, owner.*std::get<double Owner::*>(row.slot), row.range, description)
      ->capture_default_str();
}

/// The words of a setting, for an option that takes one of them.
template <class Value>
[[nodiscard]] std::vector<std::string> option_words() {
  return {words_of<Value>.begin(), words_of<Value>.end()};
}

/// The words of these values, as `word(Value)` says them.
template <class Value, std::size_t count>
[[nodiscard]] std::vector<std::string> option_words(const std::array<Value, count>& every) {
  std::vector<std::string> words;
  for (const Value one : every) words.emplace_back(word(one));
  return words;
}

/// An option that takes the word of one of these values. `Chosen`: the value, or an optional one, which is
/// none where nothing is said, or this word for it.
template <class Chosen, class Value, std::size_t count>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Chosen& value,
                        const std::array<Value, count>& every, const std::string& description,
                        const std::string& none = {}) {
  std::vector<std::string> words = option_words(every);
  if (!none.empty()) words.insert(words.begin(), none);
  const auto choose = [&value, every](const std::string& text) {
    value = Chosen{};
    for (const Value one : every)
      if (word(one) == text) value = one;
  };
  CLI::Option* option =
      command.add_option_function<std::string>(name, choose, description)->check(CLI::IsMember(words));
  if constexpr (std::is_same_v<Chosen, Value>)
    option->default_str(std::string(word(value)));
  else if (!none.empty())
    option->default_str(none);
  return option;
}

}  // namespace seamline::inline stimuli
