#include "study/trials/rendered_set.h"

#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/text/error.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

void check_study_belongs(const RenderedSet& set, const fs::path& study_file) {
  const std::string found = study_hash(set.study);
  if (found == set.manifest.study_hash) return;
  throw input_error({.file = study_file.string(),
                     .wanted = "the study that the set was rendered from (hash " +
                               set.manifest.study_hash.substr(0, 12) + "); render the set again to change it",
                     .found = "another one (hash " + found.substr(0, 12) + ")"});
}

}  // namespace

RenderedSet load_rendered_set(const fs::path& folder) {
  RenderedSet set{.folder = fs::absolute(folder).lexically_normal(),
                  .manifest = read_manifest(folder),
                  .set_hash = set_hash(folder),
                  .study = {},
                  .study_text = {}};
  const fs::path study_file = path_below(
      folder, set.manifest.study_file, {.file = (folder / "manifest.json").string(), .field = "study.file"});
  set.study = read_study(study_file, AssetCheck::not_needed);
  set.study_text = read_file(study_file);
  check_study_belongs(set, study_file);
  if (set.manifest.stimuli.empty())
    throw input_error({.file = (folder / "manifest.json").string(),
                       .field = "stimuli",
                       .wanted = "at least one stimulus",
                       .found = "none"});
  return set;
}

}  // namespace seamline::study
