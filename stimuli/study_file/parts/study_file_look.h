#pragma once
#include <memory>

#include "stimuli/definition/looks/study_look.h"
#include "stimuli/definition/study_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// The table `look` of a study or a condition, where it has one: what it does not say is as in `usual` (null:
/// the defaults). Else `usual`. Throws InputError where a value is none.
[[nodiscard]] std::shared_ptr<const LookDefinition> read_look(
    const TomlTable& settings, const std::shared_ptr<const LookDefinition>& usual);

/// Throws InputError where a look is said of pictures that do not show all directions, where panoramas are
/// not said how to be looked at, and where something else in the study is bound to one perspective view.
void check_looks(const TomlTable& study_table, const StudyDefinition& study);

}  // namespace seamline::inline stimuli
