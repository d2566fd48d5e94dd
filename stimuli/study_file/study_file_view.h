#pragma once
#include "stimuli/definition/study_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// `[view]` of a study or condition, over what it has already. `is_condition`: refuses keys that the kind
/// ignores; a study's may be for its conditions (`check_views`).
[[nodiscard]] View read_view(const TomlTable& settings, const View& usual, bool is_condition);

/// Throws InputError where a view lacks what its kind needs, a key of `[view]` is used by no condition, a
/// picture has no place on the stated screen, or a condition has a setting that knows only the photograph's
/// own pixels.
void check_views(const TomlTable& study_table, const StudyDefinition& study);

}  // namespace seamline::inline stimuli
