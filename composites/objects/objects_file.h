#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "composites/objects/photo_objects.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// What `--objects` names: virtual objects, and perhaps the light.
struct ObjectsFile {
  std::vector<PlacedModel> objects;
  bool has_light = false;
  SceneDefinition light;                 ///< suns, lamps and environment, where `has_light`
  std::optional<SceneDefinition> added;  ///< suns and lamps that exist only with the objects
};

/// Reads a TOML file of objects (documentation/how-to/composite.md). Files are looked for beside it, and
/// below `asset_root`. Throws InputError naming file and key: an unknown key, a key that makes another void,
/// no object, a file that is not there.
[[nodiscard]] ObjectsFile read_objects_file(const std::filesystem::path& path,
                                            const std::filesystem::path& asset_root);

/// The same for a text that a file held once; complaints name `path`.
[[nodiscard]] ObjectsFile parse_objects_file(const std::string& text, const std::filesystem::path& path,
                                             const std::filesystem::path& asset_root);

/// The files that it names: the objects' and the environment's.
[[nodiscard]] std::vector<std::filesystem::path> files_named_by(const ObjectsFile& file);

/// The file's text; reading it gives the same objects. Light is not written.
[[nodiscard]] std::string objects_file_text(const std::vector<PlacedModel>& objects);

}  // namespace seamline::renderer
