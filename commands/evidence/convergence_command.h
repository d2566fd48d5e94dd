#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline lab convergence`.
void add_convergence_command(CLI::App& app);

}  // namespace seamline::renderer
