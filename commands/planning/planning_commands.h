#pragma once

// Before a study: what each file of this folder adds to the command line.

namespace CLI {
class App;
}

namespace seamline::analysis {

/// Adds `seamline plan STUDY.toml`.
void add_plan_command(CLI::App& app);

/// Adds `seamline predict SET`.
void add_predict_command(CLI::App& app);

/// `seamline observe [PAIRS.csv]`.
void add_observe_command(CLI::App& app);

/// Adds `seamline freeze STUDY.toml`.
void add_freeze_command(CLI::App& app);

}  // namespace seamline::analysis
