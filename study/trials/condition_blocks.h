#pragma once
#include <string>
#include <vector>

#include "stimuli/definition/stimulus.h"
#include "study/trials/trial_sequence.h"

namespace seamline::study {

/// The order of `count` treatments in a row of Williams' design: a Latin square (two, one the mirror image of
/// the other, where `count` is odd), in whose `williams_rows(count)` rows every treatment stands once at
/// every place, and follows every other one equally often (Williams 1949). Rows repeat.
[[nodiscard]] std::vector<int> williams_row(int count, int row);
[[nodiscard]] int williams_rows(int count);

/// The same stimuli in blocks of a condition each, in the order of a Williams row of the slot. Within a block
/// they stand in the order in which they stood.
[[nodiscard]] std::vector<int> in_condition_blocks(std::vector<int> order,
                                                   const std::vector<Stimulus>& stimuli, int slot);

/// The stimulus of a condition that differs from another one by its condition alone.
[[nodiscard]] int twin_in(const std::vector<Stimulus>& stimuli, int stimulus, const std::string& condition);

/// Catch trials show what they show in the condition of the trial before them, so that they ask what the
/// trials around them ask.
void move_into_blocks(std::vector<CatchTrial>& catches, const std::vector<int>& order,
                      const std::vector<Stimulus>& stimuli);

}  // namespace seamline::study
