#pragma once
#include <filesystem>

namespace seamline::renderer {

/// Writes `SET/errors.html` (one file that opens offline, without scripts) and `SET/errors.csv`: seconds,
/// rays, estimated error and, where measured, true error of every stimulus of a rendered set.
void write_errors_page(const std::filesystem::path& set_folder);

}  // namespace seamline::renderer
