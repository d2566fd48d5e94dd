#pragma once

namespace CLI {
class App;
}

namespace seamline::analysis {

/// Adds `seamline plan STUDY.toml`.
void add_plan_command(CLI::App& app);

}  // namespace seamline::analysis
