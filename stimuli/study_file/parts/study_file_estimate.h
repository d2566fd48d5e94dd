#pragma once
#include "stimuli/definition/depth_chain.h"
#include "support/files/toml_table.h"

// Depth that is estimated, out of a study file's table `depth`.
namespace seamline::inline stimuli {

/// Whether a table has a key of estimates, beside those of any file; of stereo.
[[nodiscard]] bool names_estimate(const TomlTable& table);
[[nodiscard]] bool names_stereo(const TomlTable& table);

/// Throw InputError where a table names what only files, or only stereo, have.
void refuse_file(const TomlTable& table);
void refuse_stereo(const TomlTable& table);

/// Values, their line, and how much of them is taken. Throws InputError for a line without a scale, and for
/// metres a step of what is no distance.
[[nodiscard]] FileEstimate read_estimate(const TomlTable& table, FileEstimate usual, bool has_metres_a_step);

/// Whether `source`, a file or what the study said before, is a panorama in a file.
[[nodiscard]] bool is_panorama_file(const TomlTable& table, const DepthSource& source);
[[nodiscard]] PanoramaSource read_panorama_file(const TomlTable& table, const PanoramaSource& usual);

/// `known`: the study said before that its source is stereo.
[[nodiscard]] StereoSource read_stereo(const TomlTable& table, StereoSource usual, bool known);

}  // namespace seamline::inline stimuli
