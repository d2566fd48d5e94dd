#include "stimuli/settings/setting_value.h"

#include <fmt/core.h>

#include <type_traits>

#include "stimuli/settings/settings_text.h"
#include "support/running/overloaded.h"

namespace seamline::inline stimuli {
namespace {

template <class Value>
std::string list_text(const std::vector<Value>& values, const Wording& wording) {
  std::string text;
  for (const Value& value : values) text += fmt::format("{}{}{}", wording.before, value, wording.after);
  return text;
}

}  // namespace

std::string value_text(const SettingValue& value, const Wording& wording) {
  const auto two_text = [&](const auto& two) {
    return fmt::format("{}{}{}", two[0], wording.between, two[1]);
  };
  return std::visit(
      Overloaded{[](std::monostate) { return std::string(); },
                 [&](const std::array<int, 2>* two) { return two_text(*two); },
                 [&](const std::array<double, 2>* two) { return two_text(*two); },
                 [&](const std::optional<std::array<double, 2>>* two) {
                   return *two ? two_text(**two) : std::string();
                 },
                 [&](const std::vector<double>* values) { return list_text(*values, wording); },
                 [&](const std::vector<std::string>* values) { return list_text(*values, wording); },
                 [](const std::optional<double>* number) { return fmt::format("{}", number->value_or(0)); },
                 [&](const bool* is_so) { return std::string(*is_so ? wording.yes : wording.no); },
                 [](const std::array<double, 3>* three) { return three_text(*three); },
                 [](const Eigen::Vector3d* three) { return three_text(*three); },
                 [](const std::optional<std::array<double, 3>>* three) {
                   return *three ? three_text(**three) : std::string();
                 },
                 [](const auto* one) { return fmt::format("{}", *one); }},
      value);
}

bool are_equal(const SettingValue& one, const SettingValue& other) {
  return std::visit(
      Overloaded{[](std::monostate) { return true; },
                 [&]<class Value>(const Value* value) { return *value == *std::get<const Value*>(other); }},
      one);
}

void set_to(const SettableValue& value, const SettingValue& other) {
  std::visit(Overloaded{[](std::monostate) {},
                        [&]<class Value>(Value* settable) { *settable = *std::get<const Value*>(other); }},
             value);
}

void set_to(const SettableValue& value, double number) {
  std::visit(Overloaded{[&](double* settable) { *settable = number; },
                        [&](std::optional<double>* settable) { *settable = number; },
                        [&](int* settable) { *settable = static_cast<int>(number); }, [](const auto&) {}},
             value);
}

std::string settings::said(std::string_view key, const std::string& value) {
  return fmt::format("{} = {}", key, value);
}

void settings::add_worded(std::string& text, const Wording& wording, const std::string& value, bool is_list) {
  std::string_view before = wording.before;
  if (text.empty() && before.starts_with(", ")) before.remove_prefix(2);
  text += is_list ? value : fmt::format("{}{}{}", before, value, wording.after);
}

std::string words_text(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words)
    if (!word.empty()) text += fmt::format("{}\"{}\"", text.empty() ? "" : " or ", word);
  return text;
}

std::string beside_text(const Beside& beside) {
  const std::string words = words_text(beside.words.all());
  return settings::said(beside.key, words.empty() ? "true" : words);
}

}  // namespace seamline::inline stimuli
