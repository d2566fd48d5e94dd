#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// Adds `seamline lab field`.
void add_field_command(CLI::App& app);

}  // namespace seamline::renderer
