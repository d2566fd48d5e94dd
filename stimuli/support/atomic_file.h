#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace seamline {

/// Writes a file so that a reader sees either the old bytes or all of the new ones: temporary name beside the
/// target, flush to disk, rename. Throws InputError naming the path when it cannot be written; the temporary
/// file is removed then.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// The same for writers that need a path of their own (image libraries): `write` is given the temporary path,
/// which keeps the target's extension.
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(const std::filesystem::path& temporary)>& write);

/// All bytes of a file. Throws InputError when it cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// Makes the folder (and its parents) and proves that it can be written to. Throws InputError otherwise.
void prepare_output_folder(const std::filesystem::path& folder);

}  // namespace seamline
