#pragma once

namespace CLI {
class App;
}

namespace seamline::study::online {

/// Adds `export` to the program.
void add_export_command(CLI::App& app);

}  // namespace seamline::study::online
