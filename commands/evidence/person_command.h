#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// Adds `seamline lab person`.
void add_person_command(CLI::App& app);

}  // namespace seamline::renderer
