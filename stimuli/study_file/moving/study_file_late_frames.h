#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "stimuli/definition/methods/late_frames.h"
#include "stimuli/definition/study_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// Of the table `analysis`.
[[nodiscard]] LateFrames read_late_frames(const TomlTable& analysis);

/// Throws InputError where a study without clips speaks of frames, or one that places its levels by the
/// answers leaves some of them out.
void check_late_frames(const TomlTable& analysis, const StudyDefinition& study);

/// What the text of a study says of late frames; none of a study without clips.
[[nodiscard]] std::optional<LateFrames> read_late_frames_text(const std::string& text,
                                                              const std::filesystem::path& said_to_be);

}  // namespace seamline::inline stimuli
