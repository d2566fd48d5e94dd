#pragma once
#include "stimuli/definition/study_definition.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/assets.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// One `[scene.sun]`, or one of `suns`.
[[nodiscard]] SunDefinition read_sun(const TomlTable& table);

/// The file that a table's `key` names, where files must exist.
[[nodiscard]] std::filesystem::path find_asset(const TomlTable& table, const std::string& key,
                                               const std::string& file, const AssetFolders& folders,
                                               AssetCheck assets, BuiltinKind kind = BuiltinKind::scene);

/// The keys of light that a scene and a condition share: environment, suns, lamps, bounces, albedo, exposure.
/// What the table does not say stays as `scene` has it. Throws InputError where one key makes another void.
void read_light(const TomlTable& table, const AssetFolders& folders, AssetCheck assets,
                SceneDefinition& scene);

}  // namespace seamline::inline stimuli
