#pragma once
#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string>
#include <vector>

namespace seamline {

/// Options that belong together, under one heading of --help.
struct OptionGroup {
  const char* name;
  std::initializer_list<const char*> options;  ///< long names, "--lamp"
};

/// A command with many options: --help shows those that stand in no group and names the groups; --help-all
/// shows all. Throws CLI::OptionNotFound at an option that the command does not have.
void group_options(CLI::App& command, std::initializer_list<OptionGroup> groups);

/// --help of a command line: lines of at most 80 letters, groups only where they are asked for.
[[nodiscard]] std::shared_ptr<CLI::Formatter> help_formatter();

struct NamedCommand {
  std::string name;  ///< as it is typed: "render", "lab bench"
  CLI::App* app;
};

/// Every command that does something: those of groups such as `lab`, but not the groups themselves.
[[nodiscard]] std::vector<NamedCommand> every_command(CLI::App& program);

/// Why a command line was not understood, with the command or the option that may have been meant.
[[nodiscard]] std::string refusal_of_arguments(CLI::App& program, const CLI::ParseError& error);

}  // namespace seamline
