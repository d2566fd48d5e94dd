#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline views FRAME --out FOLDER`: the views that a 2D-plus-depth screen makes of a picture and its
/// depth.
void add_views_command(CLI::App& app);

}  // namespace seamline::renderer
