#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// Adds `seamline field`.
void add_field_command(CLI::App& app);

}  // namespace seamline::renderer
