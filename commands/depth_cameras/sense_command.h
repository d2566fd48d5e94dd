#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline sense`: what a depth camera and its colour camera deliver of a scene.
void add_sense_command(CLI::App& app);

}  // namespace seamline::renderer
