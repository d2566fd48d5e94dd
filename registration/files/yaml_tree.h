#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace seamline::registration {

/// A YAML text as the tree that JSON would be: mappings, lists, numbers and texts. Throws InputError naming
/// `file` at what is no YAML, at aliases, and at a tree deeper than cameras are; and in a build without
/// libyaml.
[[nodiscard]] nlohmann::json yaml_tree(const std::string& text, const std::string& file);

}  // namespace seamline::registration
