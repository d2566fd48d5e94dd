#pragma once
#include <vector>

#include "stimuli/definition/procedure_definition.h"
#include "stimuli/study_file/toml_table.h"

namespace seamline::inline stimuli {

/// Reads `procedure` and the table of its settings, `[quest_plus]`, from the top of a study file.
/// `depth_width_px`: the study's widths, rising. Throws InputError as read_study does.
[[nodiscard]] ProcedureDefinition read_procedure(const TomlTable& study,
                                                 const std::vector<int>& depth_width_px);

}  // namespace seamline::inline stimuli
