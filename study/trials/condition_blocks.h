#pragma once
#include <string>
#include <vector>

#include "stimuli/definition/stimulus.h"

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

}  // namespace seamline::study
