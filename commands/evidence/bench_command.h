#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline lab bench`.
void add_bench_command(CLI::App& app);

}  // namespace seamline::renderer
