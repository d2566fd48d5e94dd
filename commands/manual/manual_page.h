#pragma once
#include <string>

#include "commands/manual/command_line.h"

namespace seamline::packaging {

/// The manual page `seamline.1`: what the program is for, its commands, files and exit statuses. In the
/// language of groff's macros `man`. `version` e.g. "0.1.0"; the page bears no date.
[[nodiscard]] std::string program_page(const CommandLine& line, const std::string& version);

/// The manual page of one command, e.g. `seamline-render.1`.
[[nodiscard]] std::string command_page(const Command& command, const std::string& version);

}  // namespace seamline::packaging
