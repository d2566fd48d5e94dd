#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline picture SCENE --out FILE`: a scene file alone, with its own camera, lights and materials.
void add_picture_command(CLI::App& app);

}  // namespace seamline::renderer
