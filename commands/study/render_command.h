#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline render` and `seamline verify`.
void add_render_command(CLI::App& app);

}  // namespace seamline::renderer
