#include "registration/files/yaml_tree.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "support/text/error.h"
#include "support/text/number_option.h"
#include "support/text/printable.h"
#ifdef SEAMLINE_HAS_YAML
#include <yaml.h>
#endif

namespace seamline::registration {

#ifdef SEAMLINE_HAS_YAML
namespace {

using nlohmann::json;

constexpr int deepest_tree = 16;

class YamlReader {
 public:
  YamlReader(const std::string& text, const std::string& file) : file_(file) {
    if (!yaml_parser_initialize(&parser_)) throw wrong("no memory");
    yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()), text.size());
  }
  YamlReader(const YamlReader&) = delete;
  YamlReader& operator=(const YamlReader&) = delete;
  ~YamlReader() {
    yaml_event_delete(&event_);
    yaml_parser_delete(&parser_);
  }

  json document() {
    while (event_.type != YAML_DOCUMENT_START_EVENT) {
      if (event_.type == YAML_STREAM_END_EVENT) throw wrong("no document");
      next();
    }
    next();
    return value(0);
  }

 private:
  [[nodiscard]] InputError wrong(const std::string& found) const {
    return input_error({.file = file_, .wanted = "a camera as YAML", .found = found});
  }

  void next() {
    yaml_event_delete(&event_);
    if (!yaml_parser_parse(&parser_, &event_))
      throw wrong(fmt::format("{} in line {}", parser_.problem ? parser_.problem : "damage",
                              parser_.problem_mark.line + 1));
  }

  json value(int depth) {
    if (depth > deepest_tree) throw wrong("a deeper tree than cameras are");
    if (event_.type == YAML_SCALAR_EVENT) return scalar();
    const bool mapping = event_.type == YAML_MAPPING_START_EVENT;
    if (!mapping && event_.type != YAML_SEQUENCE_START_EVENT)
      throw wrong("an alias or another thing than values");
    json out = mapping ? json::object() : json::array();
    for (next(); event_.type != YAML_MAPPING_END_EVENT && event_.type != YAML_SEQUENCE_END_EVENT; next()) {
      if (!mapping) {
        out.push_back(value(depth + 1));
        continue;
      }
      if (event_.type != YAML_SCALAR_EVENT) throw wrong("a key that is no text");
      const std::string key = text();
      next();
      out[key] = value(depth + 1);
    }
    return out;
  }

  [[nodiscard]] std::string text() const {
    return {reinterpret_cast<const char*>(event_.data.scalar.value), event_.data.scalar.length};
  }
  [[nodiscard]] json scalar() const {
    const std::string found = text();
    if (event_.data.scalar.style == YAML_PLAIN_SCALAR_STYLE)
      if (const auto number = decimal_number(found)) return *number;
    return printable(found);
  }

  std::string file_;
  yaml_parser_t parser_{};
  yaml_event_t event_{};
};

}  // namespace

nlohmann::json yaml_tree(const std::string& text, const std::string& file) {
  // OpenCV's first line, "%YAML:1.0", is none of YAML's.
  const std::size_t line = text.starts_with("%YAML") ? text.find('\n') : 0;
  return YamlReader(line == std::string::npos ? std::string() : text.substr(line), file).document();
}
#else
nlohmann::json yaml_tree(const std::string&, const std::string& file) {
  throw input_error({.file = file,
                     .wanted = "a camera as TOML or JSON in this build, which was made without libyaml-dev",
                     .found = "YAML"});
}
#endif

}  // namespace seamline::registration
