#pragma once

namespace CLI {
class App;
}

namespace seamline {

/// Adds the subcommands of `study/` to the program. Each is parse, load, compute, write.
void add_study_commands(CLI::App& app);

}  // namespace seamline
