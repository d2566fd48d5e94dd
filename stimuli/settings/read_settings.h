#pragma once
#include <fmt/core.h>

#include <string>
#include <type_traits>
#include <vector>

#include "stimuli/settings/settings_text.h"
#include "support/files/toml_table.h"
#include "support/text/suggest.h"

// Study files by rows.
namespace seamline::inline stimuli {

/// Which of the words the text at `key` is. Throws InputError with all of them, and the one that was meant.
[[nodiscard]] std::size_t read_word(const TomlTable& table, std::string_view key,
                                    std::span<const std::string_view> words);

/// A complaint about a key that is the level and a setting as well.
[[nodiscard]] InputError level_complaint(const TomlTable& table, std::string_view key, Quantity level);

/// A value as it stands in a file, for complaints. `text` is the value's own.
[[nodiscard]] std::string found_text(const SettingValue& value, const Wording& wording,
                                     const std::string& text);

/// A complaint about a setting that has no meaning beside `head`.
[[nodiscard]] InputError beside_complaint(const TomlTable& table, std::string_view key, const Beside& beside,
                                          const std::string& head);

/// What a row allows.
struct AllowedValue {
  NumberRange range;
  std::string_view form;  ///< of two numbers: which two
};

/// Reads what stands at `key`; nothing where the row's value is of no plain type.
void read_value(const TomlTable& table, const std::string& key, const AllowedValue& allowed,
                const SettableValue& value);

template <class Owner>
void read_setting(const TomlTable& table, const Setting<Owner>& row, Owner& owner) {
  const std::string key(row.key);
  const auto* choice = std::get_if<Choice<Owner>>(&row.slot);
  if (!table.has(key)) {
    if (!row.required.empty())
      throw table.missing(key, choice != nullptr ? words_text(choice->words) : std::string(row.required));
  } else if (row.beside.is_refused && !is_used(row, owner)) {
    throw beside_complaint(table, row.key, row.beside, head_text(row, owner));
  } else if (choice != nullptr) {
    choice->choose(owner, read_word(table, row.key, choice->words));
  } else {
    read_value(table, key, {row.range, row.form}, settable_value(row, owner));
  }
  if (row.fault == nullptr) return;
  const std::string wanted = row.fault(owner);
  if (wanted.empty()) return;
  throw table.complaint(key, wanted, found_text(value_of(row, owner), row.wording, value_text(row, owner)));
}

/// Reads what a table says over what `owner` holds, row by row. Throws InputError for a value that no row
/// allows and for settings that would have no meaning. `finish` is the caller's.
template <class Owner>
void read_settings(const TomlTable& table, Owner& owner) {
  static_assert(!settings_of<Owner>.empty() || std::is_empty_v<Owner>, "include the header with its rows");
  for (const Setting<Owner>& row : settings_of<Owner>)  // a key of a row is no other one misspelt
    if (!row.key.empty() && !row.is_read_apart) static_cast<void>(table.has(std::string(row.key)));
  for (const Setting<Owner>& row : settings_of<Owner>)
    if (!row.key.empty() && !row.is_read_apart) read_setting(table, row, owner);
}

/// One setting by its key.
template <class Owner>
void read_setting(const TomlTable& table, std::string_view key, Owner& owner) {
  read_setting(table, setting<Owner>(key), owner);
}

/// Throws InputError where the table names any setting of `Owner`, which has no place here.
template <class Owner>
void refuse_settings(const TomlTable& table, const std::string& wanted, const std::string& found) {
  for (const Setting<Owner>& row : settings_of<Owner>)
    if (!row.key.empty() && table.has(std::string(row.key)))
      throw table.complaint(std::string(row.key), wanted, found);
}

/// Throws InputError where the table sets what is the level.
template <class Owner>
void refuse_level(const TomlTable& table, Quantity level) {
  for (const Setting<Owner>& row : settings_of<Owner>)
    if (row.level == level && table.has(std::string(row.key))) throw level_complaint(table, row.key, level);
}

}  // namespace seamline::inline stimuli
