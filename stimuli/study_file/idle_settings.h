#pragma once
#include "stimuli/definition/study_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// Throws InputError where the file `table` says something that changes nothing of the study read from it,
/// or two conditions differ in such alone: they would be two names of one thing. Only what earlier versions
/// accepted stands here, and those conditions; rows refuse the rest (`Beside`).
void refuse_idle_settings(const TomlTable& table, const StudyDefinition& study);

}  // namespace seamline::inline stimuli
