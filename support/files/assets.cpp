#include "support/files/assets.h"

#include <cstdlib>
#include <optional>
#include <vector>

#include "support/files/confined_path.h"
#include "support/text/error.h"
#include "support/text/request_name.h"
#include "support/text/suggest.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view builtin_prefix = "builtin:";

/// The folder of the running program. The kernel names its file, links followed, so neither the current
/// folder, nor PATH, nor a link to the program decides.
fs::path program_folder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

/// What was installed with the running program; nullopt in a build folder. It is taken whole: two
/// installations never mix.
std::optional<fs::path> installed_data() {
  std::error_code error;
  const fs::path folder = program_folder().parent_path() / "share" / "seamline";
  return fs::is_directory(folder, error) ? std::optional(folder) : std::nullopt;
}

/// Installed with the running program, or beside it when it was moved there, else where the build wrote them.
fs::path builtin_folder() {
  if (const auto data = installed_data()) return *data / "scenes" / "builtin";
  std::error_code error;
  const fs::path beside = program_folder() / "scenes" / "builtin";
  return fs::is_directory(beside, error) ? beside : fs::path(SEAMLINE_BUILTIN_DIR);
}

std::string extension_of(BuiltinKind kind) {
  return kind == BuiltinKind::scene ? ".glb" : ".exr";
}

std::vector<std::string> builtin_names(const fs::path& folder, BuiltinKind kind) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == extension_of(kind)) names.push_back(entry.path().stem().string());
  return names;
}

fs::path find_builtin(const std::string& name, BuiltinKind kind, const Complaint& where) {
  const std::string wanted = name.substr(builtin_prefix.size());
  const fs::path path = builtin_folder() / (wanted + extension_of(kind));
  const bool is_name = wanted.find('/') == std::string::npos;
  if (is_name && fs::exists(path)) return path;
  const std::string nearest = nearest_word(wanted, builtin_names(builtin_folder(), kind));
  throw input_error(
      {.file = where.file,
       .field = where.field,
       .wanted = kind == BuiltinKind::scene ? "a built-in scene or object" : "a built-in environment map",
       .found = "\"" + name + "\"" + (nearest.empty() ? "" : "; did you mean \"builtin:" + nearest + "\"?")});
}

/// What stands where a file was wanted.
std::string found_at(const fs::path& path) {
  std::error_code error;
  return (fs::is_directory(path, error) ? "a folder at " : "no file at ") + path.string();
}

}  // namespace

fs::path picture_codec_file() {
  const fs::path name = fs::path(SEAMLINE_PICTURE_CODEC).filename();
  if (installed_data()) return program_folder().parent_path() / "lib" / "seamline" / name;
  std::error_code error;
  const fs::path beside = program_folder() / name;
  return fs::is_regular_file(beside, error) ? beside : fs::path(SEAMLINE_PICTURE_CODEC);
}

std::string program_version() {
  return SEAMLINE_VERSION_TEXT;
}

fs::path builtin_study(const std::string& name) {
  const std::string file = name + ".toml";
  if (const auto data = installed_data()) return *data / "stimuli" / file;
  std::error_code error;
  const fs::path beside =
      program_folder() / "stimuli" / file;  // a build has a folder of that name, and no studies in it
  return fs::is_regular_file(beside, error) ? beside : fs::path(SEAMLINE_STUDIES_DIR) / file;
}

fs::path web_page_folder() {
  if (const auto data = installed_data()) return *data / "web";
  std::error_code error;
  const fs::path beside = program_folder() / "web";
  return fs::is_directory(beside, error) ? beside : fs::path(SEAMLINE_WEB_DIR);
}

fs::path resolve_asset(const std::string& name, const AssetFolders& folders, const std::string& field,
                       BuiltinKind kind) {
  const std::string study_file = folders.study_file.string();
  if (name.starts_with(builtin_prefix)) return find_builtin(name, kind, {.file = study_file, .field = field});
  const fs::path own_folder = folders.study_file.parent_path();
  std::error_code error;
  fs::path path = own_folder / name;
  if (!fs::is_regular_file(path, error) && !folders.asset_root.empty()) path = folders.asset_root / name;
  if (!fs::is_regular_file(path, error))
    throw input_error(
        {.file = study_file, .field = field, .wanted = "a file", .found = found_at(own_folder / name)});
  if (lies_below(path, own_folder)) return path;
  if (!folders.asset_root.empty() && lies_below(path, folders.asset_root)) return path;
  throw input_error({.file = study_file,
                     .field = field,
                     .wanted = "a file in the study file's folder or below it (or give " +
                               request_name("asset_root") + " DIR)",
                     .found = "\"" + name + "\", which lies elsewhere"});
}

fs::path resolve_named_file(const std::string& name, const std::string& option, BuiltinKind kind) {
  if (name.starts_with(builtin_prefix)) return find_builtin(name, kind, {.file = {}, .field = option});
  std::error_code error;
  if (!fs::is_regular_file(name, error))
    throw input_error({.field = option, .wanted = "a file", .found = found_at(name)});
  return name;
}

}  // namespace seamline
