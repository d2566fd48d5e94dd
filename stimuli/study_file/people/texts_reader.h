#pragma once
#include "stimuli/definition/people/language_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

inline constexpr const char* texts_format = "seamline texts 1";

/// Reads a file of texts into those of one language; what it does not say stays. A built-in file translates
/// only what the study says in Seamline's own words. Throws InputError where the file says a text that the
/// study has not, or another number of texts in a list.
void read_texts_file(const TomlTable& file, const StudyDefinition& study, bool builtin, StudyTexts& into);

}  // namespace seamline::inline stimuli
