#pragma once

namespace CLI {
class App;
}

namespace seamline::registration {

/// Adds `register` and `calibrate` to the program.
void add_registration_commands(CLI::App& app);

}  // namespace seamline::registration
