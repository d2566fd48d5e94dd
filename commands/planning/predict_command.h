#pragma once

namespace CLI {
class App;
}

namespace seamline::analysis {

/// Adds `seamline predict SET`.
void add_predict_command(CLI::App& app);

}  // namespace seamline::analysis
