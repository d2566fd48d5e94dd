#pragma once
#include <string>

#include "commands/manual/command_line.h"

namespace seamline::packaging {

/// The page of all commands (documentation/reference/commands.md): a section a command, a row an argument.
[[nodiscard]] std::string reference_page(const CommandLine& line);

}  // namespace seamline::packaging
