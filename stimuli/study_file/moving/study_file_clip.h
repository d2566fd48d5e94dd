#pragma once
#include <optional>

#include "stimuli/definition/moving/clip_definition.h"
#include "stimuli/definition/study_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// The table `clip` of a study; paths and clocks are read with what they are of.
[[nodiscard]] ClipDefinition read_clip(const TomlTable& table);

/// `path` of an object that stands at `position_m` when the clip begins. `level` is that of the study.
[[nodiscard]] ObjectMotion read_motion(const TomlTable& path, const Eigen::Vector3d& position_m,
                                       Quantity level);

/// `animation` of an object or of a scene, whose `file` it plays.
[[nodiscard]] FileAnimation read_animation(const TomlTable& animation, const std::string& file);

/// `path` of a camera.
[[nodiscard]] CameraMotion read_camera_motion(const TomlTable& path);

/// Throws InputError for what a study of clips cannot have, and for what only such a study has, where it is
/// none.
void check_clip(const TomlTable& table, const StudyDefinition& study);

}  // namespace seamline::inline stimuli
