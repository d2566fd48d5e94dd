#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// Adds the subcommands of `renderer/` to the program. Each is parse, load, compute, write.
void add_renderer_commands(CLI::App& app);

}  // namespace seamline::renderer
