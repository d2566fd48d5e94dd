#include "stimuli/settings/study_settings.h"

namespace seamline::inline stimuli {

std::string fault_of_name(const ConditionDefinition& condition) {
  const bool is_plain =
      condition.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
  return is_plain && condition.name.size() <= 60
             ? ""
             : "at most 60 lower-case letters, digits and _ (it becomes part of file names)";
}

std::string_view word(MeshDensity density) {
  return word_of(density);
}

std::string_view word(Isolation isolation) {
  return word_of(isolation);
}

}  // namespace seamline::inline stimuli
