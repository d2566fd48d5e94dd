#include "study/online/messages/strict_json.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline::study::online {
namespace {

/// What a parser tells, built into a value; `fault` is the first thing that is wrong.
class ValueBuilder {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  ValueBuilder(int deepest, std::size_t most_values) : deepest_(deepest), most_values_(most_values) {}

  JsonValue root;
  std::string fault;

  bool null() { return add({}); }
  bool boolean(bool value) { return add({.kind = JsonValue::Kind::boolean, .boolean = value}); }
  bool number_integer(number_integer_t value) {
    if (value >= 0) return fail("a minus before zero");  // what is above zero comes without a sign
    return add({.kind = JsonValue::Kind::whole, .whole = value, .real = static_cast<double>(value)});
  }
  bool number_unsigned(number_unsigned_t value) {
    if (value > static_cast<number_unsigned_t>(INT64_MAX)) return fail("a number that is too large");
    return add({.kind = JsonValue::Kind::whole,
                .whole = static_cast<std::int64_t>(value),
                .real = static_cast<double>(value)});
  }
  bool number_float(number_float_t value, const string_t& written) {
    if (value == 0 && written.starts_with('-')) return fail("a minus before zero");
    return add({.kind = JsonValue::Kind::real, .real = value});
  }
  bool string(string_t& value) { return add({.kind = JsonValue::Kind::text, .text = std::move(value)}); }
  bool binary(binary_t&) { return fail("binary data"); }
  bool start_object(std::size_t) { return open(JsonValue::Kind::object); }
  bool start_array(std::size_t) { return open(JsonValue::Kind::array); }
  bool key(string_t& name) {
    std::vector<std::string>& keys = open_.back()->keys;
    if (std::find(keys.begin(), keys.end(), name) != keys.end())
      return fail("the key \"" + printable(name, 40) + "\" twice");
    keys.push_back(std::move(name));
    return true;
  }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t place, const std::string&, const nlohmann::json::exception&) {
    return fail(fmt::format("something else at byte {}", place));
  }

 private:
  bool fail(std::string what) {
    if (fault.empty()) fault = std::move(what);
    return false;
  }
  JsonValue* place(JsonValue value) {
    if (++values_ > most_values_) return fail("too many values"), nullptr;
    if (open_.empty()) {
      root = std::move(value);
      return &root;
    }
    return &open_.back()->items.emplace_back(std::move(value));
  }
  bool add(JsonValue value) { return place(std::move(value)) != nullptr; }
  bool open(JsonValue::Kind kind) {
    if (std::ssize(open_) >= deepest_) return fail("too many levels");
    JsonValue* opened = place({.kind = kind});
    if (opened == nullptr) return false;
    open_.push_back(opened);  // nothing is added beside it while it is open, so it stays where it is
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  int deepest_;
  std::size_t most_values_;
  std::size_t values_ = 0;
  std::vector<JsonValue*> open_;
};

bool has_control_character(const std::string& text) {
  return std::any_of(text.begin(), text.end(),
                     [](char letter) { return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f; });
}

std::string shown(const JsonValue& value) {
  switch (value.kind) {
    case JsonValue::Kind::null:
      return "null";
    case JsonValue::Kind::boolean:
      return value.boolean ? "true" : "false";
    case JsonValue::Kind::whole:
      return std::to_string(value.whole);
    case JsonValue::Kind::real:
      return fmt::format("{}", value.real);
    case JsonValue::Kind::text:
      return "\"" + printable(value.text, 40) + "\"";
    case JsonValue::Kind::array:
      return "an array";
    case JsonValue::Kind::object:
      return "an object";
  }
  return {};
}

[[noreturn]] void refuse(const std::string& field, const std::string& wanted, const JsonValue& found) {
  throw input_error({.field = field, .wanted = wanted, .found = shown(found)});
}

}  // namespace

JsonValue read_strict_json(std::string_view text, const std::string& field, int deepest,
                           std::size_t most_values) {
  const auto complaint = [&](const std::string& found) {
    return input_error({.field = field, .wanted = "one JSON value in UTF-8", .found = found});
  };
  if (!is_utf8(text)) throw complaint("bytes that are no UTF-8");
  if (text.starts_with("\xEF\xBB\xBF")) throw complaint("a byte order mark");
  ValueBuilder builder(deepest, most_values);
  const bool whole = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  if (!builder.fault.empty()) throw complaint(builder.fault);
  if (!whole) throw complaint("something else");
  return std::move(builder.root);
}

JsonFields::JsonFields(const JsonValue& object, std::string path,
                       std::initializer_list<std::string_view> keys,
                       std::initializer_list<std::string_view> optional)
    : object_(object), path_(std::move(path)) {
  if (object.kind != JsonValue::Kind::object) refuse(path_, "an object", object);
  for (const std::string& key : object.keys)
    if (std::find(keys.begin(), keys.end(), key) == keys.end() &&
        std::find(optional.begin(), optional.end(), key) == optional.end())
      throw input_error(
          {.field = path_, .wanted = "known keys only", .found = "\"" + printable(key, 40) + "\""});
  for (const std::string_view key : keys)
    if (!has(key)) throw input_error({.field = path_of(key), .wanted = "a value", .found = "none"});
}

bool JsonFields::has(std::string_view key) const {
  return std::find(object_.keys.begin(), object_.keys.end(), key) != object_.keys.end();
}

std::string JsonFields::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

const JsonValue& JsonFields::at(std::string_view key) const {
  const auto found = std::find(object_.keys.begin(), object_.keys.end(), key);
  return object_.items.at(static_cast<std::size_t>(found - object_.keys.begin()));
}

const std::string& JsonFields::text(std::string_view key, std::size_t least, std::size_t most) const {
  const JsonValue& value = at(key);
  if (value.kind != JsonValue::Kind::text || value.text.size() < least || value.text.size() > most ||
      has_control_character(value.text))
    refuse(path_of(key), fmt::format("a text of {} to {} bytes without control characters", least, most),
           value);
  return value.text;
}

const std::string& JsonFields::any_text(std::string_view key) const {
  const JsonValue& value = at(key);
  if (value.kind != JsonValue::Kind::text) refuse(path_of(key), "a text", value);
  return value.text;
}

std::int64_t JsonFields::whole(std::string_view key, std::int64_t least, std::int64_t most) const {
  const JsonValue& value = at(key);
  if (value.kind != JsonValue::Kind::whole || value.whole < least || value.whole > most)
    refuse(path_of(key), fmt::format("a whole number from {} to {}", least, most), value);
  return value.whole;
}

double JsonFields::real(std::string_view key, double least, double most) const {
  const JsonValue& value = at(key);
  const bool number = value.kind == JsonValue::Kind::whole || value.kind == JsonValue::Kind::real;
  if (!number || !(value.real >= least && value.real <= most))
    refuse(path_of(key), fmt::format("a number from {} to {}", least, most), value);
  return value.real;
}

bool JsonFields::flag(std::string_view key) const {
  const JsonValue& value = at(key);
  if (value.kind != JsonValue::Kind::boolean) refuse(path_of(key), "true or false", value);
  return value.boolean;
}

}  // namespace seamline::study::online
