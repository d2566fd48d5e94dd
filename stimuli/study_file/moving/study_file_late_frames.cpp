#include "stimuli/study_file/moving/study_file_late_frames.h"

#include "stimuli/settings/people/analysis_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/study_file/parts/study_file_task.h"

namespace seamline::inline stimuli {

LateFrames read_late_frames(const TomlTable& analysis) {
  LateFrames late;
  read_settings(analysis, late);
  return late;
}

void check_late_frames(const TomlTable& analysis, const StudyDefinition& study) {
  for (const Setting<LateFrames>& row : settings_of<LateFrames>)
    if (const std::string key(row.key); analysis.has(key) && !study.clip)
      throw analysis.complaint(key, "nothing, because stills have no frames", "it in a study without [clip]");
  if (read_late_frames(analysis).trials == LateTrials::left_out && is_placed_by_answers(study))
    throw analysis.complaint("late_trials",
                             "\"used\", because the next level was placed by every answer, marked or not",
                             "\"left_out\"");
}

std::optional<LateFrames> read_late_frames_text(const std::string& text,
                                                const std::filesystem::path& said_to_be) {
  const TomlTable study = TomlTable::parse(text, said_to_be);
  if (!study.has("clip")) return std::nullopt;
  const auto analysis = study.table("analysis");
  return analysis ? read_late_frames(*analysis) : LateFrames{};
}

}  // namespace seamline::inline stimuli
