#pragma once
#include <filesystem>

#include "study/app/window/canvas.h"

namespace seamline::study::app {

/// A TrueType file for the study's texts: `wanted` when it is not empty, else the first of Debian's that is
/// there. Throws InputError when there is none.
[[nodiscard]] FontRequest find_font(const std::filesystem::path& wanted);

}  // namespace seamline::study::app
