#include "analysis/foresight/planned_task.h"

#include <fmt/format.h>

#include "study/observers/observer.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::analysis {

PlannedTask planned_task(const StudyDefinition& study, std::optional<double> false_alarms) {
  PlannedTask task{.facts = facts_of(study.task.get())};
  const std::string kind(word(task.facts.kind));
  if (task.facts.adjusts())
    throw input_error(
        {.file = study.file.string(),
         .field = "task.kind",
         .wanted = "a task with right answers (neither `plan` nor `predict` knows where people match)",
         .found = "\"" + kind + "\""});
  if (study.task) task.repetitions = study.task->repetitions;
  if (false_alarms && !task.facts.right_is_yes)
    throw input_error({.field = request_name("false_alarms"),
                       .wanted = "a [task] of kind \"yes_no\" or \"rating\" in the study",
                       .found = "\"" + kind + "\""});
  if (!task.facts.right_is_yes) return task;
  task.references = study.catches.reference;
  task.false_alarms = false_alarms.value_or(task.facts.chooses ? study::simulated_false_alarms : 0);
  return task;
}

std::string chance_sentence(const PlannedTask& task) {
  if (!task.facts.right_is_yes) return fmt::format("Chance is 1/{}.", task.facts.alternatives);
  return fmt::format(
      "Chance is the share of false alarms, {:g} %, taken from {} reference trials of each person.",
      100 * task.false_alarms, task.references);
}

}  // namespace seamline::analysis
