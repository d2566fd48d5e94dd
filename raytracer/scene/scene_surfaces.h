#pragma once
#include <string>

#include "raytracer/scene/scene_file.h"

namespace seamline::renderer {

/// Throws InputError naming `file` unless the scene has a triangle, and one that has an area: nothing else is
/// ever met. `what` it is: "a scene", "an object".
void require_surface(const SceneFile& scene, const std::string& file, const std::string& what);

/// Unless it has a triangle: one that an animation may make as small as nothing.
void require_triangles(const SceneFile& scene, const std::string& file, const std::string& what);

/// Whether +Z may be up in the file, which glTF does not have: its camera looks around with +Z above, or
/// without a camera hardly anything of it faces up or down along Y, and much along Z.
[[nodiscard]] bool may_be_z_up(const SceneFile& scene);

}  // namespace seamline::renderer
