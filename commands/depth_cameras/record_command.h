#pragma once

namespace CLI {
class App;
}

namespace seamline::live {

/// `seamline record`: a recording of a scene by a depth camera and its colour camera.
void add_record_command(CLI::App& app);

}  // namespace seamline::live
