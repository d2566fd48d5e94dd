#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/definition/study_definition.h"

namespace seamline::inline stimuli {

/// The files that a session shows besides the stimuli: pictures of the instructions and the font, as the
/// study file names them, relative to it. A set carries a copy of each beside its copy of the study file.
[[nodiscard]] std::vector<std::string> carried_files(const StudyDefinition& study);

/// Copies them from beside the study file into a set, with the folders that they lie in.
void copy_carried_files(const StudyDefinition& study, const std::filesystem::path& set_folder);

/// Throws InputError unless each of them is a path that stays below the study file's folder, so that it can
/// be copied beside it, and, where `folder` is given, a file that is there.
void check_carried_files(const StudyDefinition& study, const std::filesystem::path* folder);

}  // namespace seamline::inline stimuli
