#pragma once
#include <string>
#include <variant>

#include "stimuli/settings/setting.h"

// Values of settings without their owners: what is done with a number or a list is compiled once, not again
// for each struct that has rows.
namespace seamline::inline stimuli {

template <class... Values>
using PointerToOne = std::variant<std::monostate, Values*...>;

/// Where a setting's value is; nothing where it is a choice, a part or only described.
using SettingValue =
    PointerToOne<const double, const std::optional<double>, const int, const std::uint64_t, const bool,
                 const std::string, const std::array<int, 2>, const std::array<double, 2>,
                 const std::optional<std::array<double, 2>>, const std::array<double, 3>,
                 const std::optional<std::array<double, 3>>, const Eigen::Vector3d, const std::vector<double>,
                 const std::vector<std::string>>;
/// The same, to be set.
using SettableValue =
    PointerToOne<double, std::optional<double>, int, std::uint64_t, bool, std::string, std::array<int, 2>,
                 std::array<double, 2>, std::optional<std::array<double, 2>>, std::array<double, 3>,
                 std::optional<std::array<double, 3>>, Eigen::Vector3d, std::vector<double>,
                 std::vector<std::string>>;

namespace settings {

template <class Place, class Value, class Struct, class Owner>
void find_value(Place& place, const Setting<Struct>& row, Owner& owner) {
  if (const auto* member = std::get_if<Value Struct::*>(&row.slot)) place = &(owner.**member);
}

template <class Place, class Struct, class Owner>
[[nodiscard]] Place value_in(const Setting<Struct>& row, Owner& owner) {
  Place place;
  find_value<Place, double>(place, row, owner);
  find_value<Place, std::optional<double>>(place, row, owner);
  find_value<Place, int>(place, row, owner);
  find_value<Place, std::uint64_t>(place, row, owner);
  find_value<Place, bool>(place, row, owner);
  find_value<Place, std::string>(place, row, owner);
  find_value<Place, std::array<int, 2>>(place, row, owner);
  find_value<Place, std::array<double, 2>>(place, row, owner);
  find_value<Place, std::optional<std::array<double, 2>>>(place, row, owner);
  find_value<Place, std::array<double, 3>>(place, row, owner);
  find_value<Place, std::optional<std::array<double, 3>>>(place, row, owner);
  find_value<Place, Eigen::Vector3d>(place, row, owner);
  find_value<Place, std::vector<double>>(place, row, owner);
  find_value<Place, std::vector<std::string>>(place, row, owner);
  static_assert(std::variant_size_v<Slot<Struct>> == std::variant_size_v<Place> - 1 + 3, "a line for each");
  return place;
}

}  // namespace settings

template <class Owner>
[[nodiscard]] SettingValue value_of(const Setting<Owner>& row, const Owner& owner) {
  return settings::value_in<SettingValue>(row, owner);
}

template <class Owner>
[[nodiscard]] SettableValue settable_value(const Setting<Owner>& row, Owner& owner) {
  return settings::value_in<SettableValue>(row, owner);
}

/// A value alone: a number, "[1,2,3]".
[[nodiscard]] std::string value_text(const SettingValue& value, const Wording& wording);

/// Whether two values of one setting are equal; nothing equals nothing.
[[nodiscard]] bool are_equal(const SettingValue& one, const SettingValue& other);

/// Gives a setting another's value.
void set_to(const SettableValue& value, const SettingValue& other);

/// Gives a setting a number; nothing where it is none.
void set_to(const SettableValue& value, double number);

}  // namespace seamline::inline stimuli
