#pragma once
#include "stimuli/definition/study_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// Reads `procedure` and the table of its settings, `[quest_plus]`, from the top of a study file.
/// Axis and direction are the level's where the table does not say otherwise. Throws InputError as read_study
/// does.
[[nodiscard]] ProcedureDefinition read_procedure(const TomlTable& study, const LevelDefinition& level);

}  // namespace seamline::inline stimuli
