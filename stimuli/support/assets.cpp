#include "stimuli/support/assets.h"

#include <cstdlib>
#include <vector>

#include "stimuli/support/error.h"
#include "stimuli/support/suggest.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view builtin_prefix = "builtin:";

/// Beside the running program when it was moved there, else where the build wrote them.
fs::path builtin_folder() {
  std::error_code error;
  const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / "scenes" / "builtin";
  return fs::is_directory(beside, error) ? beside : fs::path(SEAMLINE_BUILTIN_DIR);
}

std::vector<std::string> builtin_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".glb") names.push_back(entry.path().stem().string());
  return names;
}

}  // namespace

std::string program_version() {
  return SEAMLINE_VERSION_TEXT;
}

fs::path builtin_study(const std::string& name) {
  std::error_code error;
  const fs::path beside =
      fs::read_symlink("/proc/self/exe", error).parent_path() / "stimuli" / (name + ".toml");
  return fs::is_regular_file(beside, error) ? beside : fs::path(SEAMLINE_STUDIES_DIR) / (name + ".toml");
}

fs::path resolve_asset(const std::string& name, const fs::path& study_file, const std::string& field) {
  if (name.starts_with(builtin_prefix)) {
    const std::string wanted = name.substr(builtin_prefix.size());
    const fs::path path = builtin_folder() / (wanted + ".glb");
    if (fs::exists(path)) return path;
    const std::string nearest = nearest_word(wanted, builtin_names(builtin_folder()));
    throw input_error({.file = study_file.string(),
                       .field = field,
                       .wanted = "a built-in scene or object",
                       .found = "\"" + name + "\"" +
                                (nearest.empty() ? "" : "; did you mean \"builtin:" + nearest + "\"?")});
  }
  const fs::path path = study_file.parent_path() / name;
  if (!fs::is_regular_file(path))
    throw input_error({.file = study_file.string(),
                       .field = field,
                       .wanted = "a file",
                       .found = "no file at " + path.string()});
  return path;
}

}  // namespace seamline
