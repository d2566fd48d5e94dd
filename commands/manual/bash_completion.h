#pragma once
#include <string>

#include "commands/manual/command_line.h"

namespace seamline::packaging {

/// A script for bash that completes commands, the options of each, the words that an option takes, and paths
/// wherever any text may stand. It needs no other script.
[[nodiscard]] std::string bash_completion(const CommandLine& line);

}  // namespace seamline::packaging
