#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline relight`: a virtual light on measured depth, which flickers.
void add_relight_command(CLI::App& app);

}  // namespace seamline::renderer
