#include "stimuli/definition/parts/staircase_definition.h"

#include <fmt/core.h>

namespace seamline::inline stimuli {

std::string canonical_text(const StaircaseDefinition& definition) {
  std::string text =
      fmt::format("staircase down {} up {} reversals {} trials {}{}", definition.down, definition.up,
                  definition.reversals, definition.max_trials, definition.by_object ? " each object" : "");
  for (const double start : definition.start) text += fmt::format(" start {}", start);
  return text + "\n";
}

}  // namespace seamline::inline stimuli
