#pragma once
#include <filesystem>
#include <string_view>

namespace seamline {

/// Writes a file of a folder that nobody sees until `publish_folder` has brought all of it to the disk: under
/// its own name and without a flush, since thousands of flushes take minutes. Throws InputError naming the
/// path when it cannot be written.
void write_unpublished_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace seamline
