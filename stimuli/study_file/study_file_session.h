#pragma once
#include "stimuli/definition/instructions_definition.h"
#include "stimuli/definition/methods/analysis_definition.h"
#include "stimuli/definition/session_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// Reads `[session]`. Throws InputError as read_study does.
[[nodiscard]] SessionDefinition read_session(const TomlTable& session);

/// Reads `[catch]`.
[[nodiscard]] CatchDefinition read_catches(const TomlTable& catches);

/// Reads `[analysis]`.
[[nodiscard]] AnalysisDefinition read_analysis(const TomlTable& analysis);

}  // namespace seamline::inline stimuli
