#pragma once
#include <optional>

#include "stimuli/definition/study_definition.h"
#include "support/files/assets.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

struct DepthClock;

/// The table `depth` of a study or a condition: how depth is captured. What it leaves out is `usual`'s;
/// another `source` or `preset` begins anew. Nothing where it says, or leaves, the exact panorama. Throws
/// InputError for keys that nothing would look at, links that do not go together, and what is the level.
/// `clock` is null of stills; of clips the table's frames_per_s and delay_ms are read into it.
[[nodiscard]] std::optional<DepthChain> read_depth_chain(const TomlTable& settings,
                                                         const std::optional<DepthChain>& usual,
                                                         const LevelDefinition& level, std::uint64_t seed,
                                                         DepthClock* clock);

/// Throws InputError unless the level is something that this chain has: noise, a pinhole, a speed. `width_px`
/// of the panorama, or 0 where it is the level. Depth of clips may always be late.
void require_level_in_chain(const TomlTable& settings, const std::optional<DepthChain>& chain, int width_px,
                            const LevelDefinition& level, bool is_clip);

/// Finds the files of sources. Throws InputError where one is not there, or lies outside the folders.
void find_depth_files(StudyDefinition& study, const AssetFolders& folders);

}  // namespace seamline::inline stimuli
