#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline flip`: the difference between two pictures that people see, also by region.
void add_flip_command(CLI::App& app);

}  // namespace seamline::renderer
