#pragma once
#include <string>
#include <vector>

#include "stimuli/study_definition.h"

namespace seamline {

/// What a study's scenes do not need and Seamline therefore does not compute, a sentence each; stored in the
/// manifest.
[[nodiscard]] std::vector<std::string> what_is_left_out(const StudyDefinition& study);

}  // namespace seamline
