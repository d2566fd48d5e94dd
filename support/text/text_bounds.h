#pragma once
#include <string>
#include <string_view>

namespace seamline {

/// Throws InputError naming `file` when brackets and braces of a JSON text lie deeper in each other than
/// limits::deepest_text_nesting (the readers of JSON and of what is made of it are recursive; this is not),
/// or when it has more values than limits::most_text_values (each takes many times its text's memory).
void require_bounded_json(std::string_view text, const std::string& file);

/// The same for TOML, where a dotted key (`a.b.c`) nests as deep as it has parts.
void require_bounded_toml(std::string_view text, const std::string& file);

}  // namespace seamline
