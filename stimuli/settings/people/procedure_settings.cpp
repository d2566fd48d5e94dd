#include "stimuli/settings/people/procedure_settings.h"

namespace seamline::inline stimuli {

std::string fault_of_fewest_trials(const QuestPlusDefinition& quest) {
  return quest.min_trials > quest.max_trials ? fmt::format("at most max_trials ({})", quest.max_trials) : "";
}

std::string_view word(Sigmoid sigmoid) {
  return word_of(sigmoid);
}

}  // namespace seamline::inline stimuli
