#pragma once

namespace CLI {
class App;
}

namespace seamline::analysis {

/// Adds the subcommands of `analysis/` to the program. Each is parse, load, compute, write.
void add_analysis_commands(CLI::App& app);

}  // namespace seamline::analysis
