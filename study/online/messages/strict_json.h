#pragma once
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace seamline::study::online {

/// A value of JSON. `items` are an array's, or an object's beside their `keys`.
struct JsonValue {
  enum class Kind { null, boolean, whole, real, text, array, object };
  Kind kind = Kind::null;
  bool boolean = false;
  std::int64_t whole = 0;  ///< written without point and exponent, in 64 bits
  double real = 0;         ///< also of a whole number
  std::string text = {};
  std::vector<std::string> keys = {};
  std::vector<JsonValue> items = {};
};

/// Reads one JSON text strictly: UTF-8, no key twice, no minus zero, no number beyond a double, at most
/// `deepest` levels and `most_values` values; the text's size is the caller's to bound. Throws InputError
/// with one sentence that begins with `field`.
[[nodiscard]] JsonValue read_strict_json(std::string_view text, const std::string& field, int deepest = 6,
                                         std::size_t most_values = 2000);

/// The fields of an object that has exactly these keys, and `optional` ones or not. Throws InputError at any
/// other, at a missing one, and when a value is not what is asked for. Must not outlive the value.
class JsonFields {
 public:
  JsonFields(const JsonValue& object, std::string path, std::initializer_list<std::string_view> keys,
             std::initializer_list<std::string_view> optional = {});

  [[nodiscard]] bool has(std::string_view key) const;

  [[nodiscard]] const JsonValue& at(std::string_view key) const;
  /// Without control characters; lengths in bytes.
  [[nodiscard]] const std::string& text(std::string_view key, std::size_t least, std::size_t most) const;
  /// Whatever it holds, for what will be compared with what is known.
  [[nodiscard]] const std::string& any_text(std::string_view key) const;
  [[nodiscard]] std::int64_t whole(std::string_view key, std::int64_t least, std::int64_t most) const;
  [[nodiscard]] double real(std::string_view key, double least, double most) const;
  [[nodiscard]] bool flag(std::string_view key) const;
  [[nodiscard]] std::string path_of(std::string_view key) const;

 private:
  const JsonValue& object_;
  std::string path_;
};

}  // namespace seamline::study::online
