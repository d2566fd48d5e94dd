#pragma once
#include "stimuli/definition/study_definition.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/assets.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

struct DepthClock;

/// What the study's curves run over: `[level]`, or `depth_width_px = [...]` as the short form of the
/// commonest one.
[[nodiscard]] LevelDefinition read_level(const TomlTable& study);

/// The depth settings of the study itself, besides what is the level; `seed` is that of the noise, `clock`
/// is null of stills.
[[nodiscard]] DepthSettings read_depth(const TomlTable& study, const LevelDefinition& level,
                                       std::uint64_t seed, DepthClock* clock);

/// Every `[[condition]]`, over the study's own settings and scenes, which must have been read. Throws
/// InputError where a condition sets what is the level, or what another of its settings makes void. `clip` is
/// null of stills; of clips it gets each condition's clock.
[[nodiscard]] std::vector<ConditionDefinition> read_conditions(const TomlTable& table,
                                                               const StudyDefinition& study,
                                                               const AssetFolders& folders, AssetCheck assets,
                                                               ClipDefinition* clip);

}  // namespace seamline::inline stimuli
