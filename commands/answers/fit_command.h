#pragma once

namespace CLI {
class App;
}

namespace seamline::analysis {

/// Adds `seamline fit DATA.csv`.
void add_fit_command(CLI::App& app);

}  // namespace seamline::analysis
