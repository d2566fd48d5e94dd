#pragma once
#include "scenes/shapes/glb_file.h"

namespace seamline::scenes {

/// A room open to the left, where a low sun comes in: floor, walls, ceiling, and furniture of cuboids.
[[nodiscard]] SceneContents make_bedroom();

/// An open pavilion on a lawn with the sun behind it, whose shadow reaches towards the camera.
[[nodiscard]] SceneContents make_gazebo();

/// A court of two storeys of arcades, with screens behind its columns (paper section 4.1.1). No sun.
[[nodiscard]] SceneContents make_atrium();

/// A living room open to the left with over sixty pieces of furniture, under a sun at 24 degrees: where times
/// to an error are measured against other renderers.
[[nodiscard]] SceneContents make_furnished_room();

/// The first versions of the three, on which published numbers of speed and convergence rest.
[[nodiscard]] SceneContents make_bedroom_v1();
[[nodiscard]] SceneContents make_gazebo_v1();
[[nodiscard]] SceneContents make_atrium_v1();

}  // namespace seamline::scenes
