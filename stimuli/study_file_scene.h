#pragma once
#include "stimuli/study_definition.h"
#include "stimuli/study_file.h"
#include "stimuli/toml_table.h"

namespace seamline {

/// Reads one `[[scene]]` with its `[[scene.object]]`, `[scene.sun]` and `[scene.camera]`.
[[nodiscard]] SceneDefinition read_scene(const TomlTable& table, const std::filesystem::path& study_file,
                                         AssetCheck assets);

}  // namespace seamline
