#pragma once
#include "stimuli/definition/study_definition.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/assets.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// Reads one `[[scene]]` with its `[[scene.object]]`, `[scene.sun]` and `[scene.camera]`. `clip` is null of
/// stills; of clips it gets the paths of the objects, `level` being that of the study. `objects`: how many
/// the scene must have.
[[nodiscard]] SceneDefinition read_scene(const TomlTable& table, const AssetFolders& folders,
                                         AssetCheck assets, Quantity level, ClipDefinition* clip,
                                         int objects);

}  // namespace seamline::inline stimuli
