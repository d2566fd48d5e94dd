#include "stimuli/set/set_study.h"

#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/files/hash.h"
#include "support/text/error.h"

namespace seamline::inline stimuli {
namespace fs = std::filesystem;
namespace {

/// The study whose hash the manifest says, where the set's copy has had another [observer] since.
constexpr const char* rendered_study = "rendered_study.toml";

/// Whether the set keeps a study of this hash that shows people the same.
bool keeps_identity(const fs::path& set_folder, const StudyDefinition& study, const std::string& identity) {
  const fs::path file = set_folder / rendered_study;
  std::error_code error;
  if (!fs::is_regular_file(file, error) || !lies_below(file, set_folder)) return false;
  const StudyDefinition rendered = read_study(file, AssetCheck::not_needed, {}, IdleSettings::kept);
  return study_hash(rendered) == identity && same_but_observer(rendered, study);
}

}  // namespace

fs::path study_file_of_set(const fs::path& set_folder, const Manifest& manifest) {
  return path_below(set_folder, manifest.study_file,
                    {.file = (set_folder / "manifest.json").string(), .field = "study.file"});
}

StudyDefinition study_of_set(const fs::path& set_folder, const Manifest& manifest) {
  const fs::path file = study_file_of_set(set_folder, manifest);
  StudyDefinition study = read_study(file, AssetCheck::not_needed, {}, IdleSettings::kept);
  const std::string found = study_hash(study);
  if (found == manifest.study_hash || keeps_identity(set_folder, study, manifest.study_hash)) return study;
  throw input_error({.file = file.string(),
                     .wanted = "the study that the set was rendered from (hash " +
                               manifest.study_hash.substr(0, 12) + "); render the set again to change it",
                     .found = "another one (hash " + found.substr(0, 12) + ")"});
}

bool same_but_observer(StudyDefinition a, StudyDefinition b) {
  a.observer = b.observer = {};
  return canonical_text(a) == canonical_text(b);
}

std::string set_hash_as(const fs::path& set_folder, const std::string& study_hash) {
  const std::string said = read_manifest(set_folder).study_hash;
  std::string text = read_file(set_folder / "manifest.json");
  if (const std::size_t at = text.find(said); at != std::string::npos)
    text.replace(at, said.size(), study_hash);
  return sha256(text);
}

std::string identity_in(const fs::path& set_folder, const StudyDefinition& study) {
  std::string own = study_hash(study);
  std::error_code error;
  if (!fs::is_regular_file(set_folder / "manifest.json", error)) return own;
  try {
    Manifest there = read_manifest(set_folder);
    if (same_but_observer(study_of_set(set_folder, there), study)) return there.study_hash;
  } catch (const InputError&) {
    // what lies there is no set that could go on
  }
  return own;
}

void write_study_file(const fs::path& set_folder, const StudyDefinition& study, const std::string& identity) {
  const fs::path copy = set_folder / "study.toml", kept = set_folder / rendered_study;
  if (study_hash(study) == identity) {
    write_file_atomically(copy, read_file(study.file));
    std::error_code error;
    fs::remove(kept, error);
    return;
  }
  if (!keeps_identity(set_folder, study, identity)) write_file_atomically(kept, read_file(copy));
  write_file_atomically(copy, read_file(study.file));
}

}  // namespace seamline::inline stimuli
