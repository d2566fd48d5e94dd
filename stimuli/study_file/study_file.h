#pragma once
#include <filesystem>
#include <string>

#include "stimuli/definition/methods/analysis_definition.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::inline stimuli {

/// What a reader of a study file needs of the files it names.
enum class AssetCheck {
  must_exist,    ///< rendering: every named file must be there
  not_needed,    ///< sessions and analysis: only the definition is read
  all_but_depth  ///< photographs for an estimator, whose depth maps are not there yet
};

/// What becomes of settings that change nothing. Earlier versions accepted some of them, so sets and logs
/// that are there have them, and stay readable.
enum class IdleSettings { refused, kept };

/// Reads a study file (TOML, `format = "seamline study 1"`). Strict: an unknown or misspelt key, a wrong type
/// or unit and an impossible value are each an InputError naming file, key, what was wanted and what was
/// found. Files that the study names must lie below its folder or below `asset_root` (see resolve_asset).
[[nodiscard]] StudyDefinition read_study(const std::filesystem::path& path,
                                         AssetCheck assets = AssetCheck::must_exist,
                                         const std::filesystem::path& asset_root = {},
                                         IdleSettings idle = IdleSettings::refused);

/// The same for a study file's text that is kept elsewhere (a log keeps one); the files it names are not
/// looked for, and complaints name `said_to_be`.
[[nodiscard]] StudyDefinition read_study_text(const std::string& text,
                                              const std::filesystem::path& said_to_be,
                                              IdleSettings idle = IdleSettings::kept);

/// `[analysis]` of a study file's text; what is usual where it has none. The rest is not looked at.
[[nodiscard]] AnalysisDefinition read_analysis_text(const std::string& text,
                                                    const std::filesystem::path& said_to_be);

}  // namespace seamline::inline stimuli
