#pragma once

namespace CLI {
class App;
}

namespace seamline::analysis {

/// Adds `seamline freeze STUDY.toml`.
void add_freeze_command(CLI::App& app);

}  // namespace seamline::analysis
