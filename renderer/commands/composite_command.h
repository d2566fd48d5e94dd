#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline composite`: an object into the user's own photograph, through a panoramic depth map or through
/// depth that was registered to the photograph's camera.
void add_composite_command(CLI::App& app);

}  // namespace seamline::renderer
