#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

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

}  // namespace seamline::inline stimuli
