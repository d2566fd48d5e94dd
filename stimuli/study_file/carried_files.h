#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/definition/study_definition.h"

namespace seamline {
class TomlTable;
}

namespace seamline::inline stimuli {

/// The files that a session shows besides the stimuli: pictures of the instructions and the font, as the
/// study file names them, relative to it. A set carries a copy of each beside its copy of the study file.
[[nodiscard]] std::vector<std::string> carried_files(const StudyDefinition& study);

/// Copies them from beside the study file into a set, with the folders that they lie in.
void copy_carried_files(const StudyDefinition& study, const std::filesystem::path& set_folder);

/// Throws InputError unless each of them is a path that stays below the study file's folder, so that it can
/// be copied beside it, and, where `folder` is given, a file that is there.
void check_carried_files(const StudyDefinition& study, const std::filesystem::path* folder);

/// Throws InputError unless everything that comes after the study file can carry its texts: pages, messages
/// of browsers, logs and tables. A text is one line (texts that are paragraphs may have line ends and tabs)
/// without control characters, line separators and marks that turn the direction of what follows; names are
/// short enough for file names; and the form's answers fit into one message. Asked of a study that will be
/// rendered; sets and logs of before are read as they are. (carried_texts.cpp)
void check_carried_texts(const TomlTable& table, const StudyDefinition& study);

}  // namespace seamline::inline stimuli
