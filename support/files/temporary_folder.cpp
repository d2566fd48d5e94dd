#include "support/files/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "support/text/error.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

fs::path made_from(const fs::path& pattern, const fs::path& shown, const char* wanted) {
  std::string name = pattern.string();
  if (::mkdtemp(name.data()) == nullptr)
    throw input_error({.file = shown.string(), .wanted = wanted, .found = std::strerror(errno)});
  return name;
}

fs::path place_of_the_system() {
  std::error_code error;
  fs::path place = fs::temp_directory_path(error);
  if (!error) return place;
  throw input_error({.file = "TMPDIR", .wanted = "a folder for temporary files", .found = error.message()});
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  const fs::path place = place_of_the_system();
  path_ =
      made_from(place / "seamline-XXXXXX", place, "a place for temporary files (TMPDIR names another one)");
}

TemporaryFolder::TemporaryFolder(const fs::path& beside_file)
    : path_(made_from(beside_file.parent_path() / ("." + beside_file.filename().string() + ".XXXXXX"),
                      beside_file, "a folder that can be written to")) {}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace seamline
