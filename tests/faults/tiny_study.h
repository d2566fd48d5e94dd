#pragma once
#include <filesystem>

namespace seamline::faults {

/// Writes a study of boxes, and its scene files: 4 artifacts, 3 objects, `widths` depth widths from 8 texels
/// on, pictures of 64 x 36 pixels (most of the time goes into the depth meshes, three a width). Returns the
/// study file.
std::filesystem::path write_tiny_study(const std::filesystem::path& folder, int widths);

}  // namespace seamline::faults
