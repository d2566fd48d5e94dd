#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace seamline::renderer {

/// The file that a URI of a glTF file names, as a path: %20 and its like are decoded, backslashes are
/// slashes, and steps down and up again (`a/../b`) are left out.
[[nodiscard]] std::string file_of_uri(const std::string& uri);

/// Whether a URI holds its bytes itself (`data:`, in any case).
[[nodiscard]] bool is_data_uri(std::string_view uri);

/// The bytes of a data URI (RFC 2397), whatever its media type and parameters: base64 of the usual or the
/// URL's alphabet, with or without padding, blanks, new lines and % codes among it; or text with % codes.
/// None where it is neither.
[[nodiscard]] std::optional<std::string> data_of_uri(std::string_view uri);

}  // namespace seamline::renderer
