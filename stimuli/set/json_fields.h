#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <utility>

#include "support/files/confined_path.h"
#include "support/text/error.h"

// Inside stimuli/ only: JSON does not appear in the headers that others include.
namespace seamline::inline stimuli {

using Json = nlohmann::ordered_json;

/// Reads fields of one JSON object; complaints name file and field.
class SetFields {
 public:
  SetFields(const Json& json, std::string file, std::string prefix)
      : json_(json), file_(std::move(file)), prefix_(std::move(prefix)) {}

  template <class T>
  [[nodiscard]] T get(const char* key) const {
    const auto found = json_.is_object() ? json_.find(key) : json_.end();
    if (found == json_.end()) throw complaint(key, "a value", "nothing");
    if constexpr (std::is_integral_v<T>) return whole_number<T>(key, *found);
    try {
      return found->template get<T>();
    } catch (const Json::exception&) {
      throw complaint(key, "a value of its kind", found->dump().substr(0, 40));
    }
  }
  /// The same, from `least` to `most`.
  [[nodiscard]] int number(const char* key, int least, int most) const {
    const int value = get<int>(key);
    if (value < least || value > most)
      throw complaint(key, "a whole number from " + std::to_string(least) + " to " + std::to_string(most),
                      std::to_string(value));
    return value;
  }
  [[nodiscard]] double real(const char* key, double least, double most) const {
    const auto value = get<double>(key);
    if (!(value >= least && value <= most))
      throw complaint(key, "a number from " + std::to_string(least) + " to " + std::to_string(most),
                      std::to_string(value));
    return value;
  }
  [[nodiscard]] bool has(const char* key) const { return json_.is_object() && json_.contains(key); }
  /// A file of the set; may be empty.
  [[nodiscard]] std::string file_below(const char* key) const {
    const auto name = get<std::string>(key);
    if (!is_written_below(name)) throw complaint(key, "a path below the set's folder", "\"" + name + "\"");
    return name;
  }
  [[nodiscard]] SetFields object(const char* key) const {
    if (!json_.is_object() || !json_.contains(key)) throw complaint(key, "an object", "nothing");
    return {json_.at(key), file_, prefix_ + key + "."};
  }
  [[nodiscard]] const Json& array(const char* key) const {
    if (!json_.is_object() || !json_.contains(key) || !json_.at(key).is_array())
      throw complaint(key, "an array", "nothing");
    return json_.at(key);
  }
  [[nodiscard]] InputError complaint(const char* key, const std::string& wanted,
                                     const std::string& found) const {
    return input_error({.file = file_, .field = prefix_ + key, .wanted = wanted, .found = found});
  }

 private:
  /// The JSON library would convert a fraction or a number too large, without a word.
  template <class T>
  [[nodiscard]] T whole_number(const char* key, const Json& value) const {
    const bool fits = value.is_number_unsigned()
                          ? std::in_range<T>(value.get<std::uint64_t>())
                          : value.is_number_integer() && std::in_range<T>(value.get<std::int64_t>());
    if (!fits) throw complaint(key, "a whole number of its kind", value.dump().substr(0, 40));
    return value.get<T>();
  }

  const Json& json_;
  std::string file_, prefix_;
};

}  // namespace seamline::inline stimuli
