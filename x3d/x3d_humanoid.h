#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "x3d/x3d_page.h"

namespace seamline::renderer {

/// The subject's figure as an HAnimHumanoid (ISO/IEC 19774): joints with the vertices that they hold, one
/// skin, and what turns and moves them. `appearance`: of an object's shape.
[[nodiscard]] std::string x3d_humanoid(const X3dPage& page,
                                       const std::function<std::string(std::size_t)>& appearance);

/// What the page says of it, and the switch that lets it move, where it does.
[[nodiscard]] std::string humanoid_words(const X3dSubject& subject);
[[nodiscard]] std::string humanoid_control(const X3dSubject& subject);

}  // namespace seamline::renderer
