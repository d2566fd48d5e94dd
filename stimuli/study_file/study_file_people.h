#pragma once
#include "stimuli/definition/study_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// Reads what participants are told and asked: `[consent]`, `[[form_field]]`, `[instructions]`, `[training]`
/// and `[texts]`, from the top of a study file. Throws InputError as read_study does.
void read_people(const TomlTable& study, StudyDefinition& definition);

}  // namespace seamline::inline stimuli
