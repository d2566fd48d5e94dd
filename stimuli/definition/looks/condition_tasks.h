#pragma once
#include <memory>
#include <string>
#include <vector>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::inline stimuli {

// Conditions with a task of their own (`[condition.task]`): the same pictures, asked about in several ways.

/// What a condition asks: its own task, or the study's; null: the paper's question.
[[nodiscard]] std::shared_ptr<const TaskDefinition> task_of(const StudyDefinition& study,
                                                            const std::string& condition);

[[nodiscard]] bool has_own_tasks(const StudyDefinition& study);

/// The meaning of a task, which is the paper's for null.
[[nodiscard]] std::string meaning_of_task(const TaskDefinition* task);

/// Conditions that ask the same.
struct TaskGroup {
  std::shared_ptr<const TaskDefinition> task = {};  ///< null: the paper's question
  std::vector<std::string> conditions;              ///< in the study's order
};

/// Of every task that the study asks with, each once: its own first, where some condition has it, then those
/// of conditions in their order. One where no condition has its own.
[[nodiscard]] std::vector<TaskGroup> task_groups(const StudyDefinition& study);

/// The study of these conditions alone, with their task as its own: what is planned for it follows from it.
[[nodiscard]] StudyDefinition study_of_group(const StudyDefinition& study, const TaskGroup& group);

/// What a trial of this task asks and says, in the words of the study where it has none of its own.
[[nodiscard]] AskedTexts asked_texts(const StudyDefinition& study, const TaskDefinition* task);

}  // namespace seamline::inline stimuli
