#include "stimuli/settings/people/task_settings.h"

namespace seamline::inline stimuli {

std::string fault_of_objects(const TaskDefinition& task) {
  const NumberRange range{2, most_objects_of_scene, "objects"};  // among one there is no choice
  return task.kind == TaskKind::object && task.objects < 2 ? range_text("a whole number", range) : "";
}

std::string fault_of_exposure(const TaskDefinition& task) {
  const NumberRange range{0.05, 600, "s"};
  return task.kind == TaskKind::interval && task.exposure_s < range.least ? range_text("a number", range)
                                                                          : "";
}

std::string_view word(TaskKind kind) {
  return word_of(kind);
}

std::string canonical_text(const StaircaseDefinition& definition) {
  return settings_text(definition) + "\n";
}

std::string canonical_text(const TaskDefinition* task) {
  if (task == nullptr) return {};
  return settings_text(*task) + (task->staircase ? canonical_text(*task->staircase) : std::string());
}

}  // namespace seamline::inline stimuli
