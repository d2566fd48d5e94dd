#include "study/trials/rendered_set.h"

#include "stimuli/set/set_study.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"

namespace seamline::study {
namespace fs = std::filesystem;

RenderedSet load_rendered_set(const fs::path& folder) {
  RenderedSet set{.folder = fs::absolute(folder).lexically_normal(),
                  .manifest = read_manifest(folder),
                  .set_hash = set_hash(folder),
                  .study = {},
                  .study_text = {}};
  set.study = study_of_set(folder, set.manifest);
  set.study_text = read_file(study_file_of_set(folder, set.manifest));
  if (set.manifest.stimuli.empty())
    throw input_error({.file = (folder / "manifest.json").string(),
                       .field = "stimuli",
                       .wanted = "at least one stimulus",
                       .found = "none"});
  return set;
}

}  // namespace seamline::study
