#include "stimuli/settings/people/observer_settings.h"

namespace seamline::inline stimuli {

std::string midpoints_text(const ObserverDefinition& observer) {
  std::string text;
  for (const auto& [artifact, level] : observer.midpoint)
    text += fmt::format("midpoint {} {}\n", word(artifact), level);
  for (const auto& [condition, midpoint] : observer.condition_midpoint)
    for (const auto& [artifact, level] : midpoint)
      text += fmt::format("midpoint {} {} {}\n", condition, word(artifact), level);
  return text;
}

bool has_no_midpoints(const ObserverDefinition& observer) {
  return observer.midpoint.empty() && observer.condition_midpoint.empty();
}

}  // namespace seamline::inline stimuli
