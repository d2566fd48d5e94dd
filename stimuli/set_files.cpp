#include "stimuli/set_files.h"

#include <set>

#include "stimuli/support/confined_path.h"
#include "stimuli/support/error.h"
#include "stimuli/support/hash.h"
#include "stimuli/support/parallel.h"

namespace seamline::inline stimuli {
namespace fs = std::filesystem;
namespace {

void check_exists(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) return;
  throw input_error(
      {.file = path.string(),
       .wanted = "the picture that the set was rendered with (the same `seamline render` makes it again)",
       .found = "no such file"});
}

}  // namespace

std::vector<SetFile> set_files(const Manifest& manifest) {
  std::vector<SetFile> files;
  std::set<std::string> listed;
  const auto list = [&](const std::string& file, const std::string& sha256) {
    if (listed.insert(file).second) files.push_back({file, sha256});
  };
  for (const ManifestReference& reference : manifest.references) {
    list(reference.image, reference.image_sha256);
    list(reference.object_ids, reference.object_ids_sha256);
  }
  for (const ManifestStimulus& stimulus : manifest.stimuli) list(stimulus.image, stimulus.sha256);
  return files;
}

fs::path set_file_path(const fs::path& set_folder, const std::string& name) {
  return path_below(set_folder, name, {.file = (set_folder / "manifest.json").string(), .field = "files"});
}

void check_set_file(const fs::path& set_folder, const SetFile& wanted) {
  const fs::path path = set_file_path(set_folder, wanted.file);
  check_exists(path);
  if (const std::string found = sha256_of_file(path); found != wanted.sha256)
    throw input_error({.file = path.string(),
                       .wanted = "the picture that the set was rendered with, hash " +
                                 wanted.sha256.substr(0, 16) +
                                 "... (the same `seamline render` makes it again)",
                       .found = "other bytes, hash " + found.substr(0, 16) + "..."});
}

void check_set_files_exist(const fs::path& set_folder, const Manifest& manifest) {
  for (const SetFile& wanted : set_files(manifest)) check_exists(set_file_path(set_folder, wanted.file));
}

void check_set_files(const fs::path& set_folder, const Manifest& manifest) {
  const std::vector<SetFile> files = set_files(manifest);
  run_parallel(static_cast<int>(files.size()), 0,
               [&](int index) { check_set_file(set_folder, files[static_cast<std::size_t>(index)]); });
}

}  // namespace seamline::stimuli
