#pragma once
#include <filesystem>

#include "stimuli/definition/study_definition.h"

namespace seamline {
class TomlTable;
}

namespace seamline::inline stimuli {

/// Throws InputError unless everything that comes after the study file can carry its texts: pages, messages
/// of browsers, logs and tables. A text is one line (texts that are paragraphs may have line ends and tabs)
/// without control characters, line separators and marks that turn the direction of what follows; names are
/// short enough for file names; and the form's answers fit into one message. Asked of a study that will be
/// rendered; sets and logs of before are read as they are.
void check_carried_texts(const TomlTable& table, const StudyDefinition& study);

}  // namespace seamline::inline stimuli
