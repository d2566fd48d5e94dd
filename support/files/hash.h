#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace seamline {

/// SHA-256 as 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view bytes);

/// Whether a text is 64 lower-case hexadecimal digits.
[[nodiscard]] bool is_sha256(std::string_view text);

/// SHA-256 of a file's bytes. Throws InputError when the file cannot be read, Interrupted when it is long.
[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace seamline
