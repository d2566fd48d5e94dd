#pragma once

namespace CLI {
class App;
}

namespace seamline::study::online {

/// Adds `seamline serve`.
void add_serve_command(CLI::App& app);

}  // namespace seamline::study::online
