#pragma once
#include <filesystem>

#include "stimuli/definition/study_definition.h"
#include "stimuli/set/manifest.h"

namespace seamline::inline stimuli {

/// Where the copy of the study file is that a set holds. Throws InputError when it is not inside the set.
[[nodiscard]] std::filesystem::path study_file_of_set(const std::filesystem::path& set_folder,
                                                      const Manifest& manifest);

/// The study that a set was rendered from, read from the set's own copy. Throws InputError when the file is
/// missing or wrong, or is of another study than the manifest says, but for its [observer].
[[nodiscard]] StudyDefinition study_of_set(const std::filesystem::path& set_folder, const Manifest& manifest);

/// Whether two studies show people the same: they differ at most in [observer], of which only simulated
/// people know. It is part of a study's hash, which sets, logs and pages keep as the study's identity.
[[nodiscard]] bool same_but_observer(StudyDefinition a, StudyDefinition b);

/// The hash of a set (`set_hash`) if its manifest said another study's hash.
[[nodiscard]] std::string set_hash_as(const std::filesystem::path& set_folder, const std::string& study_hash);

/// The hash under which a set of this study is known that is rendered into a folder: that of the set which
/// lies there, where the two are `same_but_observer`; else the study's own.
[[nodiscard]] std::string identity_in(const std::filesystem::path& set_folder, const StudyDefinition& study);

/// Puts the study file into a set, whose manifest is to say `identity`. Where that is not the file's own
/// hash, the file whose hash it is stays in the set as `rendered_study.toml`.
void write_study_file(const std::filesystem::path& set_folder, const StudyDefinition& study,
                      const std::string& identity);

}  // namespace seamline::inline stimuli
