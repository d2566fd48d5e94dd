#include "stimuli/definition/methods/late_frames.h"

#include <fmt/format.h>

namespace seamline::inline stimuli {

std::string sentence_of(const LateFrames& rule) {
  return fmt::format("A trial in which more than {:g} % of the clip's frames were late or dropped is {}.",
                     100 * rule.most_share,
                     rule.trials == LateTrials::used ? "marked and used all the same" : "left out");
}

}  // namespace seamline::inline stimuli
