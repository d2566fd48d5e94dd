#pragma once
#include "stimuli/study_definition.h"
#include "stimuli/study_file.h"
#include "stimuli/support/assets.h"
#include "stimuli/toml_table.h"

namespace seamline::inline stimuli {

/// Reads one `[[scene]]` with its `[[scene.object]]`, `[scene.sun]` and `[scene.camera]`.
[[nodiscard]] SceneDefinition read_scene(const TomlTable& table, const AssetFolders& folders,
                                         AssetCheck assets);

}  // namespace seamline::stimuli
