#pragma once

namespace CLI {
class App;
}

namespace seamline::analysis {

/// `seamline observe [PAIRS.csv]`.
void add_observe_command(CLI::App& app);

}  // namespace seamline::analysis
