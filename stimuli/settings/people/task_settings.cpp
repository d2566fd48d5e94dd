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

std::string fault_of_mask(const TaskDefinition& task) {
  return task.mask != TaskMask::none && task.exposure_s <= 0
             ? "\"none\" beside exposure_s = 0: a mask follows an exposure that ends"
             : "";
}

std::string fault_of_mask_time(const TaskDefinition& task) {
  return task.kind == TaskKind::interval && task.mask != TaskMask::none && task.mask_s > task.gap_s
             ? "at most gap_s, because the mask is the beginning of the gap"
             : "";
}

std::string_view word(TaskKind kind) {
  return word_of(kind);
}

std::string word(TaskMask mask) {
  return std::string(word_of(mask));
}

std::string canonical_text(const StaircaseDefinition& definition) {
  return settings_text(definition) + "\n";
}

std::string canonical_text(const TaskDefinition* task) {
  if (task == nullptr) return {};
  return settings_text(*task) + (task->staircase ? canonical_text(*task->staircase) : std::string());
}

}  // namespace seamline::inline stimuli
