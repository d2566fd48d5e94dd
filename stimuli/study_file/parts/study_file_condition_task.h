#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "stimuli/definition/study_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// `[condition.task]`; null: the condition asks what the study asks. Throws InputError where such a task
/// cannot stand beside what the study says.
[[nodiscard]] std::shared_ptr<const TaskDefinition> read_task_of_condition(const TomlTable& condition,
                                                                           const StudyDefinition& study);

/// Gives a study whose conditions have tasks of their own a page of instructions for each, unless it has
/// instructions itself, and throws InputError at what cannot stand beside them. Call it once conditions and
/// everything beside them are read.
void set_up_own_tasks(const TomlTable& study, StudyDefinition& definition);

/// The tasks of the conditions that have their own, by name, from a study file's text as a log keeps it.
using ConditionTasks = std::map<std::string, std::shared_ptr<const TaskDefinition>>;
[[nodiscard]] ConditionTasks read_condition_tasks_text(const std::string& text,
                                                       const std::filesystem::path& said_to_be);

}  // namespace seamline::inline stimuli
