#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/study_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// Reads `[task]` and `[staircase]` of a study into `definition.task`, and gives question, instructions and
/// feedback the task's own words where the file says nothing of them. Call it once session, catch trials,
/// procedure and what people are told are read. Throws InputError where a key has no meaning for the task, or
/// the study asks for something that the task cannot give.
void read_task(const TomlTable& study, StudyDefinition& definition);

/// A table of a task alone, which `usual_number_of_objects` holds for where it does not say it.
[[nodiscard]] TaskDefinition read_task_table(const TomlTable& table, int usual_number_of_objects);

/// Whether the levels of trials follow the answers before them (QUEST+, or staircases).
[[nodiscard]] bool is_placed_by_answers(const StudyDefinition& study);

/// Throws InputError where a study asks what its clips, or views that turn, cannot be asked about, has blocks
/// of conditions without any, or words before blocks that there are not. Call it once conditions are read.
void check_task_alone(const TomlTable& study, const StudyDefinition& definition);

/// The task of a study file's text, as a log keeps it; null: it names none. Looks at nothing else.
[[nodiscard]] std::shared_ptr<const TaskDefinition> read_task_text(const std::string& text,
                                                                   const std::filesystem::path& said_to_be);

}  // namespace seamline::inline stimuli
