#pragma once

// Answers: what each file of this folder adds to the command line.

namespace CLI {
class App;
}

namespace seamline::study {

/// `seamline log`: what looks after a log, a command each.
void add_log_command(CLI::App& app);

}  // namespace seamline::study

namespace seamline::study::online {

/// `seamline import` and `seamline merge`: answers that were stored elsewhere.
void add_gathering_commands(CLI::App& app);

/// `seamline export`: a set as a page or as videos, a log as tables, a scene in X3D; a command each.
void add_export_command(CLI::App& app);

}  // namespace seamline::study::online

namespace seamline::analysis {

/// Adds `seamline fit DATA.csv`.
void add_fit_command(CLI::App& app);

}  // namespace seamline::analysis
