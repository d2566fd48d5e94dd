#pragma once

namespace CLI {
class App;
}

namespace seamline::analysis {

/// `seamline analyze`: thresholds, figures and a report from a log.
void add_analyze_command(CLI::App& app);

}  // namespace seamline::analysis
