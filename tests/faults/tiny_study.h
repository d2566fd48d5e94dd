#pragma once
#include <filesystem>
#include <string>

namespace seamline::faults {

/// Writes a study of boxes, and its scene files: the artifacts named, as "\"none\", \"receiver\"", 3 objects,
/// `widths` depth widths from 8 texels on, pictures of 64 x 36 pixels (most of the time goes into the depth
/// meshes, three a width, which "none" does without). Returns the study file.
std::filesystem::path write_tiny_study(const std::filesystem::path& folder, int widths,
                                       const std::string& artifacts);

}  // namespace seamline::faults
