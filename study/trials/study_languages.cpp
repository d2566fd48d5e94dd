#include "study/trials/study_languages.h"

#include <fmt/core.h>

#include "stimuli/study_file/people/study_file_language.h"
#include "support/text/counted.h"
#include "support/text/error.h"

namespace seamline::study {

void check_whole(const StudyDefinition& study, const StudyTexts& texts) {
  const std::vector<std::string> missing = missing_texts(study, texts);
  if (missing.empty()) return;
  throw input_error(
      {.file = study.file.string(),
       .field = fmt::format("language \"{}\"", texts.tag),
       .wanted = fmt::format("every text that people read (seamline study {} --print-texts --language "
                             "{} > FILE writes what is to translate)",
                             study.file.string(), texts.tag),
       .found = fmt::format("{} missing, {} first", counted(missing.size(), "text"), missing.front())});
}

std::vector<StudyTexts> whole_languages(const StudyDefinition& study) {
  std::vector<StudyTexts> all;
  if (!study.languages) return all;
  for (const LanguageDefinition& language : study.languages->languages) {
    all.push_back(read_study_texts(study, language));
    check_whole(study, all.back());
  }
  return all;
}

}  // namespace seamline::study
