#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// The building blocks on the user's own files: `seamline capture`, `seamline mesh`.
void add_workbench_commands(CLI::App& app);

}  // namespace seamline::renderer
