#pragma once
#include <memory>

namespace CLI {
class App;
}

namespace seamline {

/// Seamline's command line: every command with its options. `any_case_failed` says after `lab stability`
/// whether it should end with another status than 0.
[[nodiscard]] std::unique_ptr<CLI::App> program(bool& any_case_failed);

/// What main does: runs one command and says what was wrong. Returns the exit status.
[[nodiscard]] int run_command_line(int argc, char** argv);

}  // namespace seamline
