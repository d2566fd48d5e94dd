#pragma once
#include <fmt/core.h>

#include <string>
#include <utility>

#include "stimuli/settings/setting_value.h"

// Values of settings as text: for hashes, complaints and pages.
namespace seamline::inline stimuli {

template <class Owner>
[[nodiscard]] std::string settings_text(const Owner& owner);

namespace settings {

template <auto member>
struct MemberOf;
template <class Struct, class Type, Type Struct::*member>
struct MemberOf<member> {
  using Owner = Struct;
  using Value = Type;
};

template <class Variant, std::size_t... places>
void begin_at(Variant& variant, std::size_t place, std::index_sequence<places...> /*of alternatives*/) {
  (static_cast<void>(place == places && (variant = std::variant_alternative_t<places, Variant>{}, true)),
   ...);
}

template <class Value>
void set_place(Value& value, std::size_t place) {
  if constexpr (std::is_enum_v<Value>)
    value = static_cast<Value>(place);
  else
    begin_at(value, place, std::make_index_sequence<std::variant_size_v<Value>>());
}

/// `shadows = "traced"`.
[[nodiscard]] std::string said(std::string_view key, const std::string& value);

/// Adds a value in its wording; a list has it around each of its values.
void add_worded(std::string& text, const Wording& wording, const std::string& value, bool is_list);

}  // namespace settings

/// The choice that an enumeration or a variant holds. `keeps`: a word said again leaves the settings of its
/// alternative as they are.
template <auto member, bool keeps = false>
[[nodiscard]] constexpr auto choice() {
  using Owner = typename settings::MemberOf<member>::Owner;
  using Value = typename settings::MemberOf<member>::Value;
  Choice<Owner> made{.words = words_of<Value>,
                     .place = [](const Owner& owner) { return place_of(owner.*member); },
                     .choose =
                         [](Owner& owner, std::size_t place) {
                           if (!keeps || place_of(owner.*member) != place)
                             settings::set_place(owner.*member, place);
                         }};
  if constexpr (!std::is_enum_v<Value>)
    made.parameters = [](const Owner& owner) {
      return std::visit([](const auto& one) { return settings_text(one); }, owner.*member);
    };
  return made;
}

/// The choice of a member among some of its values, each with a word: `{"loop", "once"}` of a boolean.
template <auto member, auto... values>
[[nodiscard]] constexpr auto one_of(std::span<const std::string_view> words) {
  using Owner = typename settings::MemberOf<member>::Owner;
  using Value = typename settings::MemberOf<member>::Value;
  return Choice<Owner>{.words = words,
                       .place =
                           [](const Owner& owner) {
                             constexpr std::array<Value, sizeof...(values)> all = {values...};
                             std::size_t place = 0;
                             while (place + 1 < all.size() && all[place] != owner.*member) ++place;
                             return place;
                           },
                       .choose =
                           [](Owner& owner, std::size_t place) {
                             constexpr std::array<Value, sizeof...(values)> all = {values...};
                             owner.*member = all.at(place);
                           }};
}

/// The words of some values.
template <auto... values>
inline constexpr std::array<std::string_view, sizeof...(values)> words_among = {word_of(values)...};

/// The same, each by its own word.
template <auto member, auto... values>
[[nodiscard]] constexpr auto one_of() {
  return one_of<member, values...>(words_among<values...>);
}

/// The settings of a member that is a struct.
template <auto member>
[[nodiscard]] constexpr auto part() {
  using Owner = typename settings::MemberOf<member>::Owner;
  using Value = typename settings::MemberOf<member>::Value;
  return Part<Owner>{.text = [](const Owner& owner) { return settings_text(owner.*member); },
                     .is_usual = [](const Owner& owner) { return owner.*member == Value{}; }};
}

/// The same of a member that may be none: its text is then empty.
template <auto member>
[[nodiscard]] constexpr auto optional_part() {
  using Owner = typename settings::MemberOf<member>::Owner;
  return Part<Owner>{
      .text =
          [](const Owner& owner) { return owner.*member ? settings_text(*(owner.*member)) : std::string(); },
      .is_usual = [](const Owner& owner) { return !(owner.*member).has_value(); }};
}

template <class Three>
[[nodiscard]] std::string three_text(const Three& three) {
  return fmt::format("[{},{},{}]", three[0], three[1], three[2]);
}

/// A value alone: a word, a number, "[1,2,3]".
template <class Owner>
[[nodiscard]] std::string value_text(const Setting<Owner>& row, const Owner& owner) {
  if (const auto* choice = std::get_if<Choice<Owner>>(&row.slot)) {
    std::string text(choice->words[choice->place(owner)]);
    if (choice->parameters != nullptr) text += choice->parameters(owner);
    return text;
  }
  if (const auto* part = std::get_if<Part<Owner>>(&row.slot)) return part->text(owner);
  return value_text(value_of(row, owner), row.wording);
}

/// Whether a setting is what it is where nothing is said.
template <class Owner>
[[nodiscard]] bool is_usual(const Setting<Owner>& row, const Owner& owner) {
  const Owner usual{};
  if (const auto* choice = std::get_if<Choice<Owner>>(&row.slot))
    return choice->place(owner) == choice->place(usual);
  if (const auto* part = std::get_if<Part<Owner>>(&row.slot)) return part->is_usual(owner);
  return are_equal(value_of(row, owner), value_of(row, usual));
}

/// `"pcf" or "pcss"`.
[[nodiscard]] std::string words_text(std::span<const std::string_view> words);

/// `shadows = "shadow_map"`, or several words with "or" between: what a setting stands beside.
[[nodiscard]] std::string beside_text(const Beside& beside);

/// `shadows = "traced"`: what the setting is that another stands beside.
template <class Owner>
[[nodiscard]] std::string head_text(const Setting<Owner>& row, const Owner& owner) {
  const Setting<Owner>& head = setting<Owner>(row.beside.key);
  const auto* choice = std::get_if<Choice<Owner>>(&head.slot);
  return settings::said(head.key, choice != nullptr
                                      ? "\"" + std::string(choice->words[choice->place(owner)]) + "\""
                                      : value_text(head, owner));
}

/// Whether a setting has a meaning beside the others.
template <class Owner>
[[nodiscard]] bool is_used(const Setting<Owner>& row, const Owner& owner) {
  if (row.beside.key.empty()) return true;
  const Setting<Owner>& head = setting<Owner>(row.beside.key);
  if (const auto* flag = std::get_if<bool Owner::*>(&head.slot)) return owner.**flag;
  const auto& choice = std::get<Choice<Owner>>(head.slot);
  return row.beside.names(choice.words[choice.place(owner)]);
}

/// Gives every setting that has no meaning beside the others its default, so that equal means the same.
template <class Owner>
void drop_idle(Owner& owner) {
  const Owner usual{};
  for (const Setting<Owner>& row : settings_of<Owner>) {
    if (!row.beside.is_refused || is_used(row, owner)) continue;
    if (const auto* choice = std::get_if<Choice<Owner>>(&row.slot))
      choice->choose(owner, choice->place(usual));
    else
      set_to(settable_value(row, owner), value_of(row, usual));
  }
}

template <class Owner>
[[nodiscard]] bool is_list(const Setting<Owner>& row) {
  return std::holds_alternative<std::vector<double> Owner::*>(row.slot) ||
         std::holds_alternative<std::vector<std::string> Owner::*>(row.slot);
}

/// The canonical text: every row in its wording, one after another. A comma has nothing before it where the
/// text begins.
template <class Owner>
std::string settings_text(const Owner& owner) {
  std::string text;
  for (const Setting<Owner>& row : settings_of<Owner>) {
    const Wording& wording = row.wording;
    if (wording.written == Written::never) continue;
    if (wording.written == Written::where_used && !is_used(row, owner)) continue;
    if (wording.written == Written::where_unusual && (is_usual(row, owner) || !is_used(row, owner))) continue;
    settings::add_worded(text, wording, value_text(row, owner), is_list(row));
  }
  return text;
}

/// Gives the setting that is the level this value; nothing where `Owner` has none.
template <class Owner>
void set_level_of(Owner& owner, Quantity quantity, double level) {
  for (const Setting<Owner>& row : settings_of<Owner>)
    if (row.level == quantity) set_to(settable_value(row, owner), level);
}

/// The row whose level this is; null where `Owner` has none.
template <class Owner>
[[nodiscard]] const Setting<Owner>* setting_of_level(Quantity quantity) {
  for (const Setting<Owner>& row : settings_of<Owner>)
    if (row.level == quantity) return &row;
  return nullptr;
}

}  // namespace seamline::inline stimuli
