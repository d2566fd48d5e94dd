#include "stimuli/set/set_study.h"

#include "stimuli/study_file/study_file.h"
#include "support/files/confined_path.h"
#include "support/text/error.h"

namespace seamline::inline stimuli {
namespace fs = std::filesystem;

fs::path study_file_of_set(const fs::path& set_folder, const Manifest& manifest) {
  return path_below(set_folder, manifest.study_file,
                    {.file = (set_folder / "manifest.json").string(), .field = "study.file"});
}

StudyDefinition study_of_set(const fs::path& set_folder, const Manifest& manifest) {
  const fs::path file = study_file_of_set(set_folder, manifest);
  StudyDefinition study = read_study(file, AssetCheck::not_needed);
  const std::string found = study_hash(study);
  if (found == manifest.study_hash) return study;
  throw input_error({.file = file.string(),
                     .wanted = "the study that the set was rendered from (hash " +
                               manifest.study_hash.substr(0, 12) + "); render the set again to change it",
                     .found = "another one (hash " + found.substr(0, 12) + ")"});
}

}  // namespace seamline::inline stimuli
