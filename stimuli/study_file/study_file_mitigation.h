#pragma once
#include "stimuli/definition/study_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// The table `mitigation` of a study or a condition; what it leaves out is `usual`'s. Throws InputError for
/// keys that nothing would look at, and for layers of depth that is no plain panorama.
[[nodiscard]] Mitigation read_mitigation(const TomlTable& settings, const Mitigation& usual);

/// Throws InputError where a condition mitigates what none of its artifacts asks of the depth mesh.
void check_mitigations_are_seen(const TomlTable& study_table, const StudyDefinition& study);

}  // namespace seamline::inline stimuli
