#pragma once
#include "scenes/shapes/glb_file.h"

namespace seamline::scenes {

/// A living room open to the left with over sixty pieces of furniture, under a sun at 24 degrees: where times
/// to an error are measured against other renderers.
[[nodiscard]] SceneContents make_furnished_room();

/// White walls, and three bays with mats and screens of saturated colours in the sun: where colours bleed
/// onto what stands there.
[[nodiscard]] SceneContents make_painted_room();

/// `glowing`: frosted panes that are the light. `open`: no panes; a lamp hangs in the room, and the sky comes
/// in.
enum class LoftWindows { glowing, open };

/// A loft with patterned floor, walls and furniture, a couch and a car, by three windows on its left: the
/// paper's Fig. 8. No sun.
[[nodiscard]] SceneContents make_loft(LoftWindows windows);

}  // namespace seamline::scenes
