#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "stimuli/definition/quantity.h"
#include "support/text/number_range.h"

// A setting of a study is described once, as a row. From rows come the reader of study files
// (read_settings.h), the canonical text that hashes are over (settings_text.h), the manifest, the options of
// commands that take the same setting, and the tables of documentation/reference/study_file.md.
namespace seamline::inline stimuli {

/// What another value makes another: the truth and all that is compared with it; the local scene and what is
/// computed from it; or only how pictures are shown and to whom.
enum class Changes { truth, depth, presentation };

/// The words of an enumeration or of a variant, in the order of its values or alternatives: one
/// specialisation each.
template <class Value>
inline constexpr std::array<std::string_view, 0> words_of = {};

template <class Value>
[[nodiscard]] constexpr std::size_t place_of(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return static_cast<std::size_t>(value);
  else
    return value.index();
}

template <class Value>
[[nodiscard]] constexpr std::string_view word_of(const Value& value) {
  return words_of<Value>.at(place_of(value));
}

/// A setting that is one of several words.
template <class Owner>
struct Choice {
  std::span<const std::string_view> words;
  std::size_t (*place)(const Owner&);   ///< which word it is
  void (*choose)(Owner&, std::size_t);  ///< an alternative that has settings begins with their defaults
  std::string (*parameters)(const Owner&) = nullptr;  ///< canonical text of the chosen alternative's settings
};

/// Settings of a member that is a struct of its own, with rows of its own.
template <class Owner>
struct Part {
  std::string (*text)(const Owner&);
  bool (*is_usual)(const Owner&);
};

/// A key that code of its own reads, because no one member holds it; here for the page.
struct Described {
  std::string_view type;
};

template <class Owner>
using Slot =
    std::variant<double Owner::*, std::optional<double> Owner::*, int Owner::*, std::uint64_t Owner::*,
                 bool Owner::*, std::string Owner::*, std::array<int, 2> Owner::*,
                 std::array<double, 2> Owner::*, std::optional<std::array<double, 2>> Owner::*,
                 std::array<double, 3> Owner::*, std::optional<std::array<double, 3>> Owner::*,
                 Eigen::Vector3d Owner::*, std::vector<double> Owner::*, std::vector<std::string> Owner::*,
                 Choice<Owner>, Part<Owner>, Described>;

/// Up to four words. (An array would do, but for GCC 12, which cannot build part of one in a constant.)
struct OneOf {
  std::string_view first = {}, second = {}, third = {}, fourth = {};

  [[nodiscard]] constexpr std::array<std::string_view, 4> all() const {
    return {first, second, third, fourth};
  }
};

/// When a setting has a meaning: beside one of these words of another setting of the same owner, which stands
/// above it. Said in vain it is refused.
struct Beside {
  std::string_view key = {};
  OneOf words = {};              ///< none: a boolean that is true
  std::string_view wanted = {};  ///< in place of `key = "word" beside it`
  bool is_refused = true;        ///< false: was accepted once, and old studies are read

  [[nodiscard]] constexpr bool names(std::string_view word) const {
    return word == words.first || word == words.second || word == words.third || word == words.fourth;
  }
};

enum class Written { never, always, where_unusual, where_used };

/// How a setting stands in the canonical text. Of a list, each value stands between `before` and `after`.
struct Wording {
  std::string_view before = {}, after = {};
  Written written = Written::always;
  std::string_view yes = "true", no = "false";  ///< of booleans
  std::string_view between = " ";               ///< of two numbers
};

/// One setting: a row. `key` is empty where only presets or other settings decide.
template <class Owner>
struct Setting {
  std::string_view key;
  Slot<Owner> slot;
  NumberRange range = {0, 0};
  std::string_view meaning = {};  ///< sentences of the reference page (Markdown)
  Beside beside = {};             ///< none: always has a meaning
  Wording wording = {.written = Written::never};
  std::optional<Quantity> level = {};  ///< the quantity that it is when it is the level
  Changes changes = Changes::depth;
  bool of_condition = true;                      ///< a [[condition]] may set it, too
  bool is_read_apart = false;                    ///< its reader is code of its own
  std::string (*fault)(const Owner&) = nullptr;  ///< what is wanted in place of such a value; empty: fine
  std::string_view required = {};                ///< what is missing without it; empty: may be left out
  std::string_view form = {};   ///< of its values, beside the range, for the page: "even"; two numbers: which
  std::string_view usual = {};  ///< the default for the page, where it is no value: "the preset's"
};

/// The rows of a struct, in the order in which they are read and written: one specialisation each.
template <class Owner>
inline constexpr std::array<Setting<Owner>, 0> settings_of = {};

template <class Owner>
[[nodiscard]] constexpr const Setting<Owner>& setting(std::string_view key) {
  for (const Setting<Owner>& row : settings_of<Owner>)
    if (row.key == key) return row;
  throw "no such setting";  // a mistake in the program: stops the compiler in constant expressions
}

/// Whether rows say what can be: each key once, each range rises, and what a setting stands beside stands
/// above it and has that word. For static_assert.
template <class Owner>
[[nodiscard]] constexpr bool are_sound(std::span<const Setting<Owner>> rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Setting<Owner>& row = rows[i];
    if (row.range.least > row.range.most) return false;
    if (!row.key.empty() && row.meaning.empty()) return false;
    bool found = row.beside.key.empty();
    for (std::size_t above = 0; above < i; ++above) {
      if (!row.key.empty() && rows[above].key == row.key) return false;
      if (rows[above].key != row.beside.key || row.beside.key.empty()) continue;
      found = true;
      const auto* choice = std::get_if<Choice<Owner>>(&rows[above].slot);
      for (const std::string_view word : row.beside.words.all()) {
        bool known = word.empty() || choice == nullptr;
        if (choice != nullptr)
          for (const std::string_view one : choice->words) known = known || one == word;
        if (!known) return false;
      }
    }
    if (!found) return false;
  }
  return true;
}

}  // namespace seamline::inline stimuli
