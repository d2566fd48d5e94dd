#include "stimuli/study_file/carried_files.h"

#include <algorithm>

#include "stimuli/study_file/people/study_file_language.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/text/error.h"

namespace seamline::inline stimuli {
namespace fs = std::filesystem;
std::vector<std::string> carried_files(const StudyDefinition& study) {
  std::vector<std::string> files;
  for (const InstructionPage& page : study.instructions)
    files.insert(files.end(), page.pictures.begin(), page.pictures.end());
  if (!study.session.font.empty()) files.push_back(study.session.font);
  const std::vector<std::string> texts = language_files(study);
  files.insert(files.end(), texts.begin(), texts.end());
  return files;
}

void copy_carried_files(const StudyDefinition& study, const fs::path& set_folder) {
  for (const std::string& file : carried_files(study)) {
    fs::create_directories((set_folder / file).parent_path());
    write_file_atomically(set_folder / file,
                          read_file(study.file.parent_path() / file, limits::largest_picture_file_bytes));
  }
}

void check_carried_files(const StudyDefinition& study, const fs::path* folder) {
  for (const std::string& file : carried_files(study)) {
    const std::vector<std::string> texts = language_files(study);
    const bool is_texts = std::find(texts.begin(), texts.end(), file) != texts.end();
    const char* field = file == study.session.font ? "session.font"
                        : is_texts                 ? "language.texts"
                                                   : "instructions.page.pictures";
    if (file.empty() || !is_written_below(file) ||
        (folder != nullptr && fs::exists(*folder / file) && !lies_below(*folder / file, *folder)))
      throw input_error({.file = study.file.string(),
                         .field = field,
                         .wanted = "a file beside the study file or in a folder below it",
                         .found = "\"" + file + "\""});
    if (folder != nullptr && !fs::is_regular_file(*folder / file))
      throw input_error({.file = study.file.string(),
                         .field = field,
                         .wanted = "a file that is there",
                         .found = "no file \"" + (*folder / file).string() + "\""});
  }
}

}  // namespace seamline::inline stimuli
