#pragma once
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace seamline {

/// Seamline's command line: every command with its options. `any_case_failed` says after `lab stability`
/// whether it should end with another status than 0.
[[nodiscard]] std::unique_ptr<CLI::App> program(bool& any_case_failed);

/// What was typed after the program's name, with commands that have moved spelled as they are today. Says so
/// on standard error.
[[nodiscard]] std::vector<std::string> todays_spelling(std::vector<std::string> arguments);

/// What main does: runs one command and says what was wrong. Returns the exit status.
[[nodiscard]] int run_command_line(int argc, char** argv);

}  // namespace seamline
