#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "stimuli/support/limits.h"

namespace seamline {

// The only place that writes files (tests/program/manners_test.cpp keeps it, and lists the exceptions).

/// Writes a file so that a reader sees either the old bytes or all of the new ones, also after a power cut:
/// temporary name beside the target, flush to disk, rename, flush of the folder. Throws InputError naming the
/// path when it cannot be written; the temporary file is removed then.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// The same for writers that need a path of their own (image libraries): `write` is given the temporary path,
/// which keeps the target's extension.
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(const std::filesystem::path& temporary)>& write);

/// All bytes of a file. Throws InputError when it cannot be read, or has more than `most_bytes`: never takes
/// much more memory than that, whatever the path leads to.
[[nodiscard]] std::string read_file(const std::filesystem::path& path,
                                    std::int64_t most_bytes = limits::largest_text_file_bytes);

/// Makes the folder (and its parents) and proves that it can be written to. Throws InputError otherwise.
void prepare_output_folder(const std::filesystem::path& folder);

}  // namespace seamline
