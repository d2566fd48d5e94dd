#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline check`.
void add_check_command(CLI::App& app);

}  // namespace seamline::renderer
