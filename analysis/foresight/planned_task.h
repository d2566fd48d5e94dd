#pragma once
#include <optional>
#include <string>

#include "analysis/joint/joint_data.h"
#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::analysis {

/// What the trials of a planned or predicted study ask, and how often.
struct PlannedTask {
  TaskFacts facts = {};
  int repetitions = 1;      ///< of each stimulus
  int references = 0;       ///< trials a participant, of tasks whose chance only they tell
  double false_alarms = 0;  ///< of those tasks: how often people say yes where they see nothing

  /// How often somebody who sees nothing is right (says yes).
  [[nodiscard]] double chance() const { return facts.right_is_yes ? false_alarms : facts.chance; }
  [[nodiscard]] int ratings() const { return facts.rates ? most_joint_ratings : 1; }
  /// One choice among three objects, then a rating.
  [[nodiscard]] bool asks_as_paper() const { return facts.is_papers(); }
};

/// Of a study. `false_alarms`: none means those of simulated people. Throws InputError where nothing is right
/// (a match), and at false alarms of a task that has none.
[[nodiscard]] PlannedTask planned_task(const StudyDefinition& study, std::optional<double> false_alarms);

/// How often somebody who sees nothing is right, and where the analysis takes it from: for a reader.
[[nodiscard]] std::string chance_sentence(const PlannedTask& task);

}  // namespace seamline::analysis
