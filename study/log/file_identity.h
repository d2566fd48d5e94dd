#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

namespace seamline::study {

/// Which file a path leads to: a file that is deleted and made again, or another one moved there, differs.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  bool operator==(const FileIdentity&) const = default;
};

/// None where there is no file.
[[nodiscard]] std::optional<FileIdentity> file_identity(const std::filesystem::path& path);

}  // namespace seamline::study
