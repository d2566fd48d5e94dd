#pragma once
#include "stimuli/definition/study_definition.h"
#include "stimuli/study_file/study_file_words.h"

namespace seamline::inline stimuli {

/// Reads what participants are told and asked: `[consent]`, `[[form_field]]`, `[instructions]`, `[training]`
/// and `[texts]`, from the top of a study file. Throws InputError as read_study does.
void read_people(const TomlTable& study, StudyDefinition& definition);

}  // namespace seamline::inline stimuli
