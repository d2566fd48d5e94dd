#pragma once
#include <filesystem>

#include "stimuli/definition/study_definition.h"
#include "stimuli/set/manifest.h"

namespace seamline::inline stimuli {

/// Where the copy of the study file is that a set holds. Throws InputError when it is not inside the set.
[[nodiscard]] std::filesystem::path study_file_of_set(const std::filesystem::path& set_folder,
                                                      const Manifest& manifest);

/// The study that a set was rendered from, read from the set's own copy. Throws InputError when the file is
/// missing or wrong, or is of another study than the manifest says.
[[nodiscard]] StudyDefinition study_of_set(const std::filesystem::path& set_folder, const Manifest& manifest);

}  // namespace seamline::inline stimuli
