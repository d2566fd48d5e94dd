#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "support/text/limits.h"

namespace seamline {

// The only place that writes files (tests/program/manners_test.cpp keeps it, and lists the exceptions).

/// Who may read a file that is made: whom the umask lets, or its owner alone (0600), because it holds what
/// people answered.
enum class Readers { everybody, owner };

/// Writes a file so that a reader sees either the old bytes or all of the new ones, also after a power cut:
/// temporary name beside the target that nobody else can have, flush to disk, rename, flush of the folder.
/// Throws InputError naming the path when it cannot be written; the temporary file is removed then.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes,
                           Readers readers = Readers::everybody);

/// Writes a file of a folder that nobody sees before `publish_folder`: under its own name and without a
/// flush, since thousands of flushes take minutes. Throws InputError naming the path when it cannot be
/// written.
void write_unpublished_file(const std::filesystem::path& path, std::string_view bytes);

/// Brings everything of a folder that is whole to the disk, and gives it its name. `folder` and `name` lie on
/// one file system; an empty folder of that name is replaced. Throws InputError naming `name` where there is
/// anything else.
void publish_folder(const std::filesystem::path& folder, const std::filesystem::path& name);

/// All bytes of a file. Throws InputError when it cannot be read, or has more than `most_bytes`: never takes
/// much more memory than that, whatever the path leads to.
[[nodiscard]] std::string read_file(const std::filesystem::path& path,
                                    std::int64_t most_bytes = limits::largest_text_file_bytes);

/// Makes the folder (and its parents) and proves that it can be written to. Throws InputError otherwise.
void prepare_output_folder(const std::filesystem::path& folder);

}  // namespace seamline
