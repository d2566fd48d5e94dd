#pragma once

namespace CLI {
class App;
}

namespace seamline {

/// Adds `seamline plan STUDY.toml`.
void add_plan_command(CLI::App& app);

}  // namespace seamline
