#pragma once
#include "study/placement/trial.h"

namespace seamline::study {

/// An answer as procedures that place levels read it: they know the object's place alone, so what was right
/// of a task with alternatives of its own becomes that place, and what was wrong another one. `right_index`:
/// the right alternative; 0 where the object's place is, and then nothing changes.
[[nodiscard]] inline TrialAnswer placed_answer(TrialAnswer answer, int right_index, int object_index) {
  if (right_index == 0) return answer;
  answer.chosen_index =
      answer.chosen_index == right_index ? object_index : 1 + object_index % objects_per_stimulus;
  return answer;
}

}  // namespace seamline::study
