#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline lab marker`: how far a marker is, by vision and by time of flight (paper 002, Fig. 3).
void add_marker_command(CLI::App& app);

}  // namespace seamline::renderer
