#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/manifest.h"

namespace seamline::inline stimuli {

/// A file that a manifest names, relative to the set's folder, and the SHA-256 of its bytes.
struct SetFile {
  std::string file;
  std::string sha256;
};

/// Every picture of a set: references, their click maps, stimuli; each file once.
[[nodiscard]] std::vector<SetFile> set_files(const Manifest& manifest);

/// Where a file is that the manifest names. Everything that opens one asks here: throws InputError when a
/// link leads out of the set's folder, because a set may have come from somebody else.
[[nodiscard]] std::filesystem::path set_file_path(const std::filesystem::path& set_folder,
                                                  const std::string& name);

/// Throws InputError unless the file is there and has the bytes that the set was rendered with.
void check_set_file(const std::filesystem::path& set_folder, const SetFile& wanted);

/// Throws InputError naming the first picture of the set that is not there. Opens none of them: thousands
/// take milliseconds.
void check_set_files_exist(const std::filesystem::path& set_folder, const Manifest& manifest);

/// check_set_file for every picture of the set, on all cores.
void check_set_files(const std::filesystem::path& set_folder, const Manifest& manifest);

}  // namespace seamline::stimuli
