#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "support/text/error.h"
#include "support/text/number_range.h"

namespace seamline {

/// A table of a TOML file that is read strictly: every key asked for is remembered, and `finish` complains
/// about any other, suggesting the nearest known one. All complaints name file and key
/// (`scene[0].object[1].scale`), wanted and found.
class TomlTable {
 public:
  /// Throws InputError when the file is missing or is not TOML (with line and column).
  [[nodiscard]] static TomlTable read(const std::filesystem::path& path);

  /// The same for a text that a file held once; complaints name `path`.
  [[nodiscard]] static TomlTable parse(const std::string& text, const std::filesystem::path& path);

  [[nodiscard]] bool has(const std::string& key) const;
  [[nodiscard]] bool is_text(const std::string& key) const;  ///< it is there and a text
  [[nodiscard]] double number(const std::string& key, double fallback, NumberRange range) const;
  [[nodiscard]] int integer(const std::string& key, int fallback, NumberRange range) const;
  [[nodiscard]] std::int64_t long_integer(const std::string& key, std::int64_t fallback,
                                          NumberRange range) const;
  [[nodiscard]] bool boolean(const std::string& key, bool fallback) const;
  [[nodiscard]] std::string text(const std::string& key) const;  ///< must be there and not empty
  [[nodiscard]] std::string text(const std::string& key, const std::string& fallback) const;
  [[nodiscard]] std::array<double, 3> triple(const std::string& key, const std::array<double, 3>& fallback,
                                             NumberRange range) const;
  [[nodiscard]] std::vector<int> integers(const std::string& key,
                                          NumberRange range) const;  ///< must be there and not empty
  [[nodiscard]] std::vector<double> numbers(const std::string& key,
                                            NumberRange range) const;  ///< must be there and not empty
  [[nodiscard]] std::vector<std::string> texts(
      const std::string& key) const;  ///< must be there and not empty
  [[nodiscard]] std::optional<TomlTable> table(const std::string& key) const;
  [[nodiscard]] std::vector<TomlTable> tables(
      const std::string& key) const;  ///< array of tables; may be absent or empty

  /// Calls `look` with every text of this table and of the tables and arrays below it, and its field; texts
  /// of an array bear the array's field.
  void for_each_text(
      const std::function<void(const std::string& field, const std::string& text)>& look) const;

  /// Throws InputError when the table holds a key that nobody asked for.
  void finish() const;

  /// A complaint about one of this table's keys.
  [[nodiscard]] InputError complaint(const std::string& key, const std::string& wanted,
                                     const std::string& found) const;
  /// The same of a key that must be there and is not. Where the table has a key that nobody asked for and
  /// that looks like it, the complaint is about that one, as `finish` says it.
  [[nodiscard]] InputError missing(const std::string& key, const std::string& wanted) const;
  [[nodiscard]] std::string field(const std::string& key) const;

 private:
  struct Node;
  TomlTable(std::shared_ptr<const Node> node, std::string file, std::string prefix);

  [[nodiscard]] InputError unknown(const std::string& key, const std::string& nearest) const;

  std::shared_ptr<const Node> node_;
  std::string file_;
  std::string prefix_;
  mutable std::set<std::string> asked_;
};

}  // namespace seamline
