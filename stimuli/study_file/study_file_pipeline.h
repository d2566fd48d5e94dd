#pragma once
#include "stimuli/definition/study_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// `[pipeline]` of a study or condition, over what it has already. Refuses what is the level, and what
/// another of its keys makes void.
[[nodiscard]] Pipeline read_pipeline(const TomlTable& settings, const LevelDefinition& level,
                                     const Pipeline& usual);

/// Throws InputError where a method is set that no artifact of a condition looks at, that another setting
/// answers instead, or where the level is one of a method that a condition does not use.
void check_pipelines_are_seen(const TomlTable& study_table, const StudyDefinition& study);

}  // namespace seamline::inline stimuli
