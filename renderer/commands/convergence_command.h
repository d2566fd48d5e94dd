#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline convergence`.
void add_convergence_command(CLI::App& app);

}  // namespace seamline::renderer
