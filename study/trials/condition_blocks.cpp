#include "study/trials/condition_blocks.h"

#include <algorithm>
#include <cstddef>

namespace seamline::study {

int williams_rows(int count) {
  return count % 2 == 0 ? count : 2 * count;
}

std::vector<int> williams_row(int count, int row) {
  // The first row is 0, 1, n - 1, 2, n - 2, ...; each further row adds one to it, modulo n.
  const int turn = row % williams_rows(count);
  std::vector<int> order;
  for (int place = 0; place < count; ++place) {
    const int step = place % 2 == 1 ? (place + 1) / 2 : count - place / 2;
    order.push_back((step + turn) % count);
  }
  if (turn >= count) std::reverse(order.begin(), order.end());
  return order;
}

std::vector<int> in_condition_blocks(std::vector<int> order, const std::vector<Stimulus>& stimuli, int slot) {
  std::vector<std::string> conditions;
  for (const Stimulus& stimulus : stimuli)
    if (std::find(conditions.begin(), conditions.end(), stimulus.condition) == conditions.end())
      conditions.push_back(stimulus.condition);
  const std::vector<int> row = williams_row(static_cast<int>(conditions.size()), slot);
  const auto block_of = [&](int stimulus) {
    const std::string& condition = stimuli[stimulus].condition;
    const auto number = std::find(conditions.begin(), conditions.end(), condition) - conditions.begin();
    return std::find(row.begin(), row.end(), static_cast<int>(number)) - row.begin();
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return block_of(a) < block_of(b); });
  return order;
}

int twin_in(const std::vector<Stimulus>& stimuli, int stimulus, const std::string& condition) {
  const Stimulus& one = stimuli[stimulus];
  const auto found = std::find_if(stimuli.begin(), stimuli.end(), [&](const Stimulus& other) {
    return other.condition == condition && other.scene == one.scene && other.artifact == one.artifact &&
           other.object_index == one.object_index && other.level == one.level;
  });
  return found == stimuli.end() ? stimulus : static_cast<int>(found - stimuli.begin());
}

void move_into_blocks(std::vector<CatchTrial>& catches, const std::vector<int>& order,
                      const std::vector<Stimulus>& stimuli) {
  for (CatchTrial& one : catches) {
    const int before = std::clamp(one.after_stimulus_trials, 1, static_cast<int>(order.size())) - 1;
    const int stimulus = order[before];
    one.trial.stimulus = twin_in(stimuli, one.trial.stimulus, stimuli[stimulus].condition);
  }
}

}  // namespace seamline::study
