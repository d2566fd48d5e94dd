#pragma once
#include <filesystem>

namespace seamline {

/// A new folder that only its owner may enter (0700) and whose name nobody can foresee, removed with all that
/// is in it. The only place that makes temporary folders: what another user could have laid ready is never
/// used (tests/program/manners_test.cpp).
class TemporaryFolder {
 public:
  /// Among the system's temporary files (TMPDIR, else /tmp). Throws InputError when none can be made.
  TemporaryFolder();
  /// Beside a file that is made in it and then takes its name: on the same file system. Throws InputError.
  explicit TemporaryFolder(const std::filesystem::path& beside_file);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::filesystem::path& name) const {
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace seamline
