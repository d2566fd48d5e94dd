// The only file that includes toml++ (through toml_library.h).
#include "support/files/toml_table.h"

#include <fmt/core.h>

#include <cmath>
#include <sstream>

#include "support/files/atomic_file.h"
#include "support/files/toml_library.h"
#include "support/text/printable.h"
#include "support/text/suggest.h"
#include "support/text/text_bounds.h"

namespace seamline {

struct TomlTable::Node {
  std::shared_ptr<const toml::table> root;  ///< keeps the file alive
  const toml::table* table = nullptr;
};

namespace {

std::string shown(const toml::node& node) {
  std::ostringstream out;
  node.visit([&](const auto& value) {
    if constexpr (toml::is_string<decltype(value)>) {
      out << '"' << value.get() << '"';
    } else if constexpr (toml::is_table<decltype(value)>) {
      out << "a table";
    } else if constexpr (toml::is_array<decltype(value)>) {
      out << (value.empty() ? "an empty array" : fmt::format("an array of {}", value.size()));
    } else if constexpr (toml::is_floating_point<decltype(value)>) {
      const std::string shortest = fmt::format("{}", value.get());  // that reads as the same number
      out << shortest << (shortest.find_first_not_of("-0123456789") == std::string::npos ? ".0" : "");
    } else {
      out << value;
    }
  });
  return out.str();
}

/// The library's own way to write an array counts its columns with numbers that can be -1 (found by
/// fuzz/study).
std::string shown_list(const toml::array& array) {
  std::string list;
  for (const toml::node& item : array) list += (list.empty() ? "" : ", ") + shown(item);
  return "[" + list + "]";
}

using LookAtText = std::function<void(const std::string& field, const std::string& text)>;

void look_at_texts(const toml::node& node, const std::string& field, const LookAtText& look) {
  if (node.is_string()) return look(field, node.as_string()->get());
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, item] : *table)
      look_at_texts(item, (field.empty() ? "" : field + ".") + std::string(key.str()), look);
  } else if (const toml::array* array = node.as_array()) {
    std::size_t number = 0;
    for (const toml::node& item : *array)
      look_at_texts(item, item.is_string() ? field : fmt::format("{}[{}]", field, number++), look);
  }
}

/// Editors of Windows save UTF-16, or one byte a letter; the parser's words do not say so.
void require_utf8(const std::string& text, const std::filesystem::path& path) {
  if (is_utf8(text)) return;
  const bool is_utf16 = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  std::size_t line = 1, begin = 0;  // the first line that is not
  for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1, ++line)
    if (!is_utf8(std::string_view(text).substr(begin, end - begin))) break;
  throw input_error({.file = path.string(),
                     .field = is_utf16 ? "" : fmt::format("line {}", line),
                     .wanted = "text in UTF-8 (save the file anew with that encoding)",
                     .found = is_utf16 ? "UTF-16" : "letters in another encoding"});
}

}  // namespace

TomlTable::TomlTable(std::shared_ptr<const Node> node, std::string file, std::string prefix)
    : node_(std::move(node)), file_(std::move(file)), prefix_(std::move(prefix)) {}

TomlTable TomlTable::read(const std::filesystem::path& path) {
  return parse(read_file(path, limits::largest_study_file_bytes), path);
}

TomlTable TomlTable::parse(const std::string& text, const std::filesystem::path& path) {
  require_utf8(text, path);
  require_bounded_toml(text, path.string());
  try {
    auto root = std::make_shared<const toml::table>(toml::parse(text, path.string()));
    const toml::table* top = root.get();
    return {std::make_shared<const Node>(Node{std::move(root), top}), path.string(), ""};
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw input_error({.file = path.string(),
                       .field = fmt::format("line {}, column {}", at.line, at.column),
                       .wanted = "valid TOML",
                       .found = std::string(error.description())});
  } catch (const TomlAssertion&) {
    throw input_error(
        {.file = path.string(), .wanted = "valid TOML", .found = "a table or array without its end"});
  }
}

std::string TomlTable::field(const std::string& key) const {
  return prefix_.empty() ? key : prefix_ + "." + key;
}

InputError TomlTable::complaint(const std::string& key, const std::string& wanted,
                                const std::string& found) const {
  return input_error({.file = file_, .field = field(key), .wanted = wanted, .found = found});
}

InputError TomlTable::unknown(const std::string& key, const std::string& nearest) const {
  return complaint(
      key, nearest.empty() ? "a key that Seamline knows" : "a known key; did you mean \"" + nearest + "\"?",
      "\"" + key + "\"");
}

InputError TomlTable::missing(const std::string& key, const std::string& wanted) const {
  for (const auto& [other, node] : *node_->table) {
    const std::string name(other.str());
    if (asked_.contains(name) || node.is_table() || node.is_array_of_tables()) continue;
    const bool alike =
        !nearest_word(name, std::array{key}).empty() && !nearest_word(key, std::array{name}).empty();
    if (alike) return unknown(name, key);
  }
  return complaint(key, wanted, "nothing");
}

bool TomlTable::has(const std::string& key) const {
  asked_.insert(key);
  return node_->table->contains(key);
}

bool TomlTable::is_text(const std::string& key) const {
  return has(key) && node_->table->get(key)->is_string();
}

double TomlTable::number(const std::string& key, double fallback, NumberRange range) const {
  if (!has(key)) return fallback;
  const toml::node& node = *node_->table->get(key);
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value || !inside(*value, range)) throw complaint(key, range_text("a number", range), shown(node));
  return *value;
}

int TomlTable::integer(const std::string& key, int fallback, NumberRange range) const {
  return static_cast<int>(long_integer(key, fallback, range));
}

std::int64_t TomlTable::long_integer(const std::string& key, std::int64_t fallback, NumberRange range) const {
  if (!has(key)) return fallback;
  const toml::node& node = *node_->table->get(key);
  const std::optional<std::int64_t> value = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
  if (!value || !inside(static_cast<double>(*value), range))
    throw complaint(key, range_text("a whole number", range), shown(node));
  return *value;
}

bool TomlTable::boolean(const std::string& key, bool fallback) const {
  if (!has(key)) return fallback;
  const toml::node& node = *node_->table->get(key);
  if (!node.is_boolean()) throw complaint(key, "true or false", shown(node));
  return *node.value<bool>();
}

std::string TomlTable::text(const std::string& key, const std::string& fallback) const {
  if (!has(key)) return fallback;
  const toml::node& node = *node_->table->get(key);
  if (!node.is_string() || node.as_string()->get().empty())
    throw complaint(key, "a text in quotes", shown(node));
  return node.as_string()->get();
}

std::string TomlTable::text(const std::string& key) const {
  if (!has(key)) throw missing(key, "a text in quotes");
  return text(key, "");
}

std::array<double, 3> TomlTable::triple(const std::string& key, const std::array<double, 3>& fallback,
                                        NumberRange range) const {
  if (!has(key)) return fallback;
  const toml::node& node = *node_->table->get(key);
  const toml::array* array = node.as_array();
  std::array<double, 3> values{};
  bool good = array != nullptr && array->size() == 3;
  for (std::size_t i = 0; good && i < 3; ++i) {
    const toml::node& item = (*array)[i];
    values[i] = item.is_number() ? item.value<double>().value_or(std::nan("")) : std::nan("");
    good = inside(values[i], range);
  }
  if (!good)
    throw complaint(key, range_text("three numbers, each", range),
                    array != nullptr && array->size() <= 4 ? shown_list(*array) : shown(node));
  return values;
}

std::vector<int> TomlTable::integers(const std::string& key, NumberRange range) const {
  if (!has(key)) throw missing(key, "an array of whole numbers");
  const toml::node& node = *node_->table->get(key);
  const toml::array* array = node.as_array();
  if (array == nullptr || array->empty()) throw complaint(key, "an array of whole numbers", shown(node));
  std::vector<int> values;
  for (const toml::node& item : *array) {
    const std::optional<std::int64_t> value = item.is_integer() ? item.value<std::int64_t>() : std::nullopt;
    if (!value || !inside(static_cast<double>(*value), range))
      throw complaint(key, range_text("whole numbers, each", range), shown(item));
    values.push_back(static_cast<int>(*value));
  }
  return values;
}

std::vector<double> TomlTable::numbers(const std::string& key, NumberRange range) const {
  if (!has(key)) throw missing(key, "an array of numbers");
  const toml::node& node = *node_->table->get(key);
  const toml::array* array = node.as_array();
  if (array == nullptr || array->empty()) throw complaint(key, "an array of numbers", shown(node));
  std::vector<double> values;
  for (const toml::node& item : *array) {
    const std::optional<double> value = item.is_number() ? item.value<double>() : std::nullopt;
    if (!value || !inside(*value, range))
      throw complaint(key, range_text("numbers, each", range), shown(item));
    values.push_back(*value);
  }
  return values;
}

std::vector<std::string> TomlTable::texts(const std::string& key) const {
  if (!has(key)) throw missing(key, "an array of texts");
  const toml::node& node = *node_->table->get(key);
  const toml::array* array = node.as_array();
  if (array == nullptr || array->empty()) throw complaint(key, "an array of texts", shown(node));
  std::vector<std::string> values;
  for (const toml::node& item : *array) {
    if (!item.is_string()) throw complaint(key, "an array of texts", shown(item));
    values.push_back(item.as_string()->get());
  }
  return values;
}

std::optional<TomlTable> TomlTable::table(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  const toml::node& node = *node_->table->get(key);
  if (!node.is_table()) throw complaint(key, "a table [" + field(key) + "]", shown(node));
  return TomlTable(std::make_shared<const Node>(Node{node_->root, node.as_table()}), file_, field(key));
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const {
  std::vector<TomlTable> found;
  if (!has(key)) return found;
  const toml::node& node = *node_->table->get(key);
  if (node.is_array() && node.as_array()->empty()) return found;
  if (!node.is_array_of_tables()) throw complaint(key, "tables [[" + field(key) + "]]", shown(node));
  for (const toml::node& item : *node.as_array())
    found.push_back(TomlTable(std::make_shared<const Node>(Node{node_->root, item.as_table()}), file_,
                              fmt::format("{}[{}]", field(key), found.size())));
  return found;
}

void TomlTable::for_each_text(const LookAtText& look) const {
  look_at_texts(*node_->table, prefix_, look);
}

void TomlTable::finish() const {
  const std::vector<std::string> known(asked_.begin(), asked_.end());
  for (const auto& [key, node] : *node_->table) {
    const std::string name(key.str());
    if (asked_.contains(name)) continue;
    throw unknown(name, nearest_word(name, known));
  }
}

}  // namespace seamline
