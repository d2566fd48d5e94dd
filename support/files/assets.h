#pragma once
#include <filesystem>
#include <string>

namespace seamline {

/// Seamline's version, e.g. "0.1.0".
[[nodiscard]] std::string program_version();

/// The library that decodes and encodes pictures (support/codec): of the same installation or build as the
/// running program. Not looked whether it is there.
[[nodiscard]] std::filesystem::path picture_codec_file();

/// A study file that comes with Seamline, e.g. "quick" for `stimuli/quick.toml`. Studies and built-in scenes
/// lie in `../share/seamline` beside the folder of the program itself, or else where it was built.
[[nodiscard]] std::filesystem::path builtin_study(const std::string& name);

/// The folder of the page that `export web` writes (index.html, seamline.js, jspsych.js): of the same
/// installation or build as the running program. Not looked whether it is there: a build may be without.
[[nodiscard]] std::filesystem::path web_page_folder();

/// Where files that a study file names may lie: below the study file's own folder, or below the folder that
/// the person at the command line trusts (`--asset-root`; empty: none).
struct AssetFolders {
  std::filesystem::path study_file;
  std::filesystem::path asset_root = {};
};

/// What `builtin:NAME` stands for: NAME.glb, a scene or object, or NAME.exr, an environment map.
enum class BuiltinKind { scene, environment };

/// The file that a study names: `builtin:NAME` is among the built-in files; a relative path is looked for in
/// the study file's folder, then in the asset root. Throws InputError (naming `field` of the study file) when
/// there is no such file, or when it lies, links followed, outside both folders.
[[nodiscard]] std::filesystem::path resolve_asset(const std::string& name, const AssetFolders& folders,
                                                  const std::string& field,
                                                  BuiltinKind kind = BuiltinKind::scene);

/// The file that a person names on the command line: any path, or `builtin:NAME`. Throws InputError naming
/// `option` when there is none.
[[nodiscard]] std::filesystem::path resolve_named_file(const std::string& name, const std::string& option,
                                                       BuiltinKind kind = BuiltinKind::scene);

}  // namespace seamline
