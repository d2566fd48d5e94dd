#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline settle`: a body falls on depth, and shakes with it.
void add_settle_command(CLI::App& app);

}  // namespace seamline::renderer
