#pragma once
#include <filesystem>
#include <string>

#include "support/text/error.h"

namespace seamline {

/// Whether a path, as it is written, names something below the folder it is taken from: relative, without
/// `..`.
[[nodiscard]] bool is_written_below(const std::filesystem::path& path);

/// Whether `path`, after following every link, lies in `folder` or below it. False when there is no such
/// file or folder.
[[nodiscard]] bool lies_below(const std::filesystem::path& path, const std::filesystem::path& folder);

/// `folder / name`, where `name` comes from a file that somebody may have sent. Throws InputError (with
/// `where.file` and `where.field`) when it is written as leaving the folder, or leaves it through a link. A
/// file that is not there passes: whoever opens it complains.
[[nodiscard]] std::filesystem::path path_below(const std::filesystem::path& folder, const std::string& name,
                                               const Complaint& where);

}  // namespace seamline
