#pragma once

namespace CLI {
class App;
}

namespace seamline::study {

/// `seamline log`: what looks after a log, a command each.
void add_log_command(CLI::App& app);

}  // namespace seamline::study
