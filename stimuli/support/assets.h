#pragma once
#include <filesystem>
#include <string>

namespace seamline {

/// Seamline's version, e.g. "0.1.0".
[[nodiscard]] std::string program_version();

/// A study file that comes with Seamline, e.g. "quick" for `stimuli/quick.toml`.
[[nodiscard]] std::filesystem::path builtin_study(const std::string& name);

/// The file that a study names: `builtin:NAME` is NAME.glb among the built-in scenes, anything else a path
/// relative to the study file's folder. Throws InputError (naming `field` of `study_file`) when there is no
/// such file.
[[nodiscard]] std::filesystem::path resolve_asset(const std::string& name,
                                                  const std::filesystem::path& study_file,
                                                  const std::string& field);

}  // namespace seamline
