#pragma once
#include "composites/place/place_request.h"

// Photographs: what each file of this folder adds to the command line.

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

/// `seamline picture SCENE --out FILE`: a scene file alone, with its own camera, lights and materials.
void add_picture_command(CLI::App& app);

/// `seamline flip`: the difference between two pictures that people see, also by region.
void add_flip_command(CLI::App& app);

/// `seamline views FRAME --out FOLDER`: the views that a 2D-plus-depth screen makes of a picture and its
/// depth.
void add_views_command(CLI::App& app);

/// `seamline export x3d`: a scene as a page in X3DOM.
void add_x3d_command(CLI::App& group);

}  // namespace seamline::renderer
