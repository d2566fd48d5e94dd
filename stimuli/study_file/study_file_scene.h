#pragma once
#include "stimuli/definition/study_definition.h"
#include "stimuli/study_file/study_file.h"
#include "stimuli/study_file/toml_table.h"
#include "support/files/assets.h"

namespace seamline::inline stimuli {

/// Reads one `[[scene]]` with its `[[scene.object]]`, `[scene.sun]` and `[scene.camera]`.
[[nodiscard]] SceneDefinition read_scene(const TomlTable& table, const AssetFolders& folders,
                                         AssetCheck assets);

/// The keys that a scene and a condition share: light, bounces, exposure, albedo. What the table does not say
/// stays as `scene` has it.
void read_light(const TomlTable& table, SceneDefinition& scene);

}  // namespace seamline::inline stimuli
