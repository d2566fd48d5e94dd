#pragma once
#include <fmt/core.h>

#include <string>
#include <type_traits>
#include <vector>

#include "stimuli/settings/settings_text.h"
#include "support/files/toml_table.h"
#include "support/running/overloaded.h"
#include "support/text/suggest.h"

// Study files by rows.
namespace seamline::inline stimuli {

/// Which of the words the text at `key` is. Throws InputError with all of them, and the one that was meant.
[[nodiscard]] std::size_t read_word(const TomlTable& table, std::string_view key,
                                    std::span<const std::string_view> words);

/// A complaint about a key that is the level and a setting as well.
[[nodiscard]] InputError level_complaint(const TomlTable& table, std::string_view key, Quantity level);

/// A value as it stands in a file, for complaints.
template <class Owner>
[[nodiscard]] std::string found_text(Setting<Owner> row, const Owner& owner) {
  if (std::holds_alternative<std::string Owner::*>(row.slot)) return "\"" + value_text(row, owner) + "\"";
  const bool is_two = std::holds_alternative<std::array<double, 2> Owner::*>(row.slot);
  if (is_two) row.wording.between = ", ";
  return is_two ? "[" + value_text(row, owner) + "]" : value_text(row, owner);
}

/// Two numbers at `key`; `form` says which two.
[[nodiscard]] std::array<double, 2> read_two(const TomlTable& table, const std::string& key,
                                             NumberRange range, std::string_view form);
[[nodiscard]] std::array<int, 2> read_two_whole(const TomlTable& table, const std::string& key,
                                                NumberRange range, std::string_view form);

template <class Owner>
void read_setting(const TomlTable& table, const Setting<Owner>& row, Owner& owner) {
  const std::string key(row.key);
  if (!table.has(key)) {
    if (!row.required.empty()) throw table.complaint(key, std::string(row.required), "nothing");
  } else if (row.beside.is_refused && !is_used(row, owner)) {
    const std::string wanted(row.beside.wanted);
    throw table.complaint(key, wanted.empty() ? beside_text(row) + " beside it" : wanted,
                          head_text(row, owner));
  } else {
    std::visit(
        Overloaded{
            [&](double Owner::*member) { owner.*member = table.number(key, 0, row.range); },
            [&](std::optional<double> Owner::*member) { owner.*member = table.number(key, 0, row.range); },
            [&](int Owner::*member) { owner.*member = table.integer(key, 0, row.range); },
            [&](std::uint64_t Owner::*member) {
              owner.*member = static_cast<std::uint64_t>(table.long_integer(key, 0, row.range));
            },
            [&](bool Owner::*member) { owner.*member = table.boolean(key, false); },
            [&](std::string Owner::*member) { owner.*member = table.text(key); },
            [&](std::array<int, 2> Owner::*member) {
              owner.*member = read_two_whole(table, key, row.range, row.form);
            },
            [&](std::array<double, 2> Owner::*member) {
              owner.*member = read_two(table, key, row.range, row.form);
            },
            [&](std::optional<std::array<double, 2>> Owner::*member) {
              owner.*member = read_two(table, key, row.range, row.form);
            },
            [&](std::vector<double> Owner::*member) { owner.*member = table.numbers(key, row.range); },
            [&](std::vector<std::string> Owner::*member) { owner.*member = table.texts(key); },
            [&](std::array<double, 3> Owner::*member) {
              owner.*member = table.triple(key, {0, 0, 0}, row.range);
            },
            [&](Eigen::Vector3d Owner::*member) {
              const std::array<double, 3> three = table.triple(key, {0, 0, 0}, row.range);
              owner.*member = {three[0], three[1], three[2]};
            },
            [&](std::optional<std::array<double, 3>> Owner::*member) {
              owner.*member = table.triple(key, {0, 0, 0}, row.range);
            },
            [&](const Choice<Owner>& choice) {
              choice.choose(owner, read_word(table, row.key, choice.words));
            },
            [](const Part<Owner>&) {}, [](const Described&) {}},
        row.slot);
  }
  if (row.fault == nullptr) return;
  const std::string wanted = row.fault(owner);
  if (wanted.empty()) return;
  throw table.complaint(key, wanted, found_text(row, owner));
}

/// Reads what a table says over what `owner` holds, row by row. Throws InputError for a value that no row
/// allows and for settings that would have no meaning. `finish` is the caller's.
template <class Owner>
void read_settings(const TomlTable& table, Owner& owner) {
  static_assert(!settings_of<Owner>.empty() || std::is_empty_v<Owner>, "include the header with its rows");
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
