#pragma once
#include "composites/place/place_request.h"

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline composite`: an object into the user's own photograph, through a panoramic depth map or through
/// depth that was registered to the photograph's camera.
void add_composite_command(CLI::App& app);

/// `seamline place`: the same photograph, depth and light in a window, where objects are put on real
/// surfaces. Without `in_window` the command says that this build has none.
void add_place_command(CLI::App& app, PlaceInWindow in_window);

}  // namespace seamline::renderer
