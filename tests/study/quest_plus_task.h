#pragma once
#include <algorithm>
#include <vector>

#include "study/placement/quest_plus_model.h"

namespace seamline::study {

inline const std::vector<int> seven_widths_px = {64, 128, 256, 512, 1024, 2048, 4096};

/// The defaults of a study file for these widths.
inline QuestPlusDefinition definition_for(const std::vector<int>& width_px) {
  QuestPlusDefinition definition;
  definition.threshold = {width_px.front() / 2.0, width_px.back() * 2.0, 41};
  definition.max_shows_per_image = 1000;
  return definition;
}

/// A track without images: grid and tables.
struct Task {
  QuestPlusDefinition definition;
  QuestPlusGrid grid;
  std::vector<int> width_px;
  QuestPlusTables tables;

  /// The stimulus that leaves the least expected entropy.
  [[nodiscard]] int best(const QuestPlusPosterior& posterior) const {
    const std::vector<double> expected = expected_entropies_nats(tables, posterior);
    return static_cast<int>(std::min_element(expected.begin(), expected.end()) - expected.begin());
  }
};

inline Task make_task(PlacementOutcome outcome, const std::vector<int>& width_px = seven_widths_px) {
  Task task{.definition = definition_for(width_px), .grid = {}, .width_px = width_px, .tables = {}};
  task.definition.outcome = outcome;
  task.grid = make_grid(task.definition);
  task.tables = make_level_tables(task.definition, task.grid, {width_px.begin(), width_px.end()});
  return task;
}

}  // namespace seamline::study
