#include "stimuli/settings/read_settings.h"

#include "support/running/overloaded.h"

namespace seamline::inline stimuli {
namespace {

template <class Number>
std::array<Number, 2> read_two(const TomlTable& table, const std::string& key, std::string_view form,
                               const std::vector<Number>& two) {
  if (two.size() != 2) throw table.complaint(key, std::string(form), fmt::format("{} numbers", two.size()));
  return {two[0], two[1]};
}

}  // namespace

std::size_t read_word(const TomlTable& table, std::string_view key, std::span<const std::string_view> words) {
  const std::string text = table.text(std::string(key));
  for (std::size_t place = 0; place < words.size(); ++place)
    if (words[place] == text) return place;
  const std::string nearest = nearest_word(text, std::vector<std::string>(words.begin(), words.end()));
  throw table.complaint(
      std::string(key), words_text(words),
      fmt::format("\"{}\"{}", text, nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?"));
}

void read_value(const TomlTable& table, const std::string& key, const AllowedValue& allowed,
                const SettableValue& value) {
  const NumberRange& range = allowed.range;
  std::visit(
      Overloaded{[](std::monostate) {}, [&](double* settable) { *settable = table.number(key, 0, range); },
                 [&](std::optional<double>* settable) { *settable = table.number(key, 0, range); },
                 [&](int* settable) { *settable = table.integer(key, 0, range); },
                 [&](std::uint64_t* settable) {
                   *settable = static_cast<std::uint64_t>(table.long_integer(key, 0, range));
                 },
                 [&](bool* settable) { *settable = table.boolean(key, false); },
                 [&](std::string* settable) { *settable = table.text(key); },
                 [&](std::array<int, 2>* settable) {
                   *settable = read_two(table, key, allowed.form, table.integers(key, range));
                 },
                 [&](std::array<double, 2>* settable) {
                   *settable = read_two(table, key, allowed.form, table.numbers(key, range));
                 },
                 [&](std::optional<std::array<double, 2>>* settable) {
                   *settable = read_two(table, key, allowed.form, table.numbers(key, range));
                 },
                 [&](std::vector<double>* settable) { *settable = table.numbers(key, range); },
                 [&](std::vector<std::string>* settable) { *settable = table.texts(key); },
                 [&](std::array<double, 3>* settable) {
                   *settable = table.triple(key, {0, 0, 0}, range);
                 },
                 [&](Eigen::Vector3d* settable) {
                   const std::array<double, 3> three = table.triple(key, {0, 0, 0}, range);
                   *settable = {three[0], three[1], three[2]};
                 },
                 [&](std::optional<std::array<double, 3>>* settable) {
                   *settable = table.triple(key, {0, 0, 0}, range);
                 }},
      value);
}

std::string found_text(const SettingValue& value, const Wording& wording, const std::string& text) {
  if (std::holds_alternative<const std::string*>(value)) return "\"" + text + "\"";
  if (!std::holds_alternative<const std::array<double, 2>*>(value)) return text;
  Wording in_file = wording;
  in_file.between = ", ";
  return "[" + value_text(value, in_file) + "]";
}

InputError beside_complaint(const TomlTable& table, std::string_view key, const Beside& beside,
                            const std::string& head) {
  const std::string wanted(beside.wanted);
  return table.complaint(std::string(key), wanted.empty() ? beside_text(beside) + " beside it" : wanted,
                         head);
}

InputError level_complaint(const TomlTable& table, std::string_view key, Quantity level) {
  return table.complaint(std::string(key), fmt::format("nothing, because {} is the level", facts(level).key),
                         "a setting of its own");
}

}  // namespace seamline::inline stimuli
