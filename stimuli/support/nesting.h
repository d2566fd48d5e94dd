#pragma once
#include <string>
#include <string_view>

namespace seamline {

/// Throws InputError naming `file` when brackets and braces of a JSON text lie deeper in each other than
/// limits::deepest_text_nesting. The readers of JSON and of what is made of it are recursive; this is not.
void require_shallow_json(std::string_view text, const std::string& file);

/// The same for TOML, where a dotted key (`a.b.c`) nests as deep as it has parts.
void require_shallow_toml(std::string_view text, const std::string& file);

}  // namespace seamline
