#include "support/files/confined_path.h"

#include <algorithm>

namespace seamline {
namespace fs = std::filesystem;

bool is_written_below(const fs::path& path) {
  return path.is_relative() && path.native().find('\0') == std::string::npos &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

bool lies_below(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  if (error) return false;
  const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) return false;
  return std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
}

fs::path path_below(const fs::path& folder, const std::string& name, const Complaint& where) {
  fs::path path = folder / name;
  std::error_code error;
  const bool leaves = !is_written_below(name) || (fs::exists(path, error) && !lies_below(path, folder));
  if (leaves)
    throw input_error({.file = where.file,
                       .field = where.field,
                       .wanted = "a file in the folder of the file that names it, or below",
                       .found = "\"" + name + "\", which leads out of it"});
  return path;
}

}  // namespace seamline
