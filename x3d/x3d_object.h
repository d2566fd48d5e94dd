#pragma once
#include <filesystem>
#include <string>

#include "x3d/x3d_page.h"

namespace seamline::renderer {

/// Lights of X3D's own: suns, lamps, and the sky as what comes from everywhere. Where a shader draws the
/// objects they are read by other systems alone.
[[nodiscard]] std::string x3d_lights(const X3dPage& page);

/// The virtual objects: diffuse, in the mean colour of each mesh, and less of the sky where they hide it
/// themselves (`openness`). With WebGL 2 a shader lights them, which knows both shadows (001, section 5.3)
/// and reads the maps of `depth_background`; without it X3DOM does, without shadows. `folder`: where the
/// shaders are.
[[nodiscard]] std::string x3d_objects(const X3dPage& page, const std::filesystem::path& folder);

}  // namespace seamline::renderer
