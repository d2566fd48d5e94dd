#pragma once

namespace CLI {
class App;
}

namespace seamline::sensors {

/// `seamline animate`: recorded joints move the figure of a file.
void add_animate_command(CLI::App& app);

}  // namespace seamline::sensors
