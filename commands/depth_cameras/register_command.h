#pragma once

namespace CLI {
class App;
}

namespace seamline::registration {

/// `seamline register`: a depth map and a photograph of the user's own, brought together.
void add_register_command(CLI::App& app);

}  // namespace seamline::registration
