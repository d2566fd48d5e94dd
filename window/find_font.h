#pragma once
#include <filesystem>

#include "window/canvas.h"

namespace seamline::inline window {

/// A TrueType file for the study's texts: `wanted` when it is not empty, else the first of Debian's that is
/// there. Throws InputError when there is none.
[[nodiscard]] FontRequest find_font(const std::filesystem::path& wanted);

}  // namespace seamline::inline window
