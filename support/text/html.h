#pragma once
#include <string>
#include <string_view>

namespace seamline {

/// Text that may come from a file or a person, made safe in HTML text and in quoted attributes, and shown as
/// `clean_text` has it.
[[nodiscard]] std::string html_escape(std::string_view text);

/// RFC 4648 base64 with padding.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace seamline
