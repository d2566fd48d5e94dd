#include "stimuli/settings/read_settings.h"

namespace seamline::inline stimuli {

std::size_t read_word(const TomlTable& table, std::string_view key, std::span<const std::string_view> words) {
  const std::string text = table.text(std::string(key));
  for (std::size_t place = 0; place < words.size(); ++place)
    if (words[place] == text) return place;
  const std::string nearest = nearest_word(text, std::vector<std::string>(words.begin(), words.end()));
  throw table.complaint(
      std::string(key), words_text(words),
      fmt::format("\"{}\"{}", text, nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?"));
}

std::array<double, 2> read_two(const TomlTable& table, const std::string& key, NumberRange range,
                               std::string_view form) {
  const std::vector<double> two = table.numbers(key, range);
  if (two.size() != 2) throw table.complaint(key, std::string(form), fmt::format("{} numbers", two.size()));
  return {two[0], two[1]};
}

std::array<int, 2> read_two_whole(const TomlTable& table, const std::string& key, NumberRange range,
                                  std::string_view form) {
  const std::vector<int> two = table.integers(key, range);
  if (two.size() != 2) throw table.complaint(key, std::string(form), fmt::format("{} numbers", two.size()));
  return {two[0], two[1]};
}

InputError level_complaint(const TomlTable& table, std::string_view key, Quantity level) {
  return table.complaint(std::string(key), fmt::format("nothing, because {} is the level", facts(level).key),
                         "a setting of its own");
}

}  // namespace seamline::inline stimuli
