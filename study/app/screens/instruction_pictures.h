#pragma once
#include <vector>

#include "study/trials/rendered_set.h"
#include "window/window_texture.h"

namespace seamline::study::app {

/// The pictures of each instruction page. Throws InputError when a file is missing or is no picture.
[[nodiscard]] std::vector<std::vector<WindowTexture>> load_instruction_pictures(const RenderedSet& set);

}  // namespace seamline::study::app
