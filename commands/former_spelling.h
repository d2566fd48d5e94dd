#pragma once
#include <string>
#include <vector>

namespace seamline {

/// What was typed after the program's name, with commands that have moved spelled as they are today; says so
/// on standard error. Throws InputError where one former command is several of today's.
[[nodiscard]] std::vector<std::string> todays_spelling(std::vector<std::string> arguments);

}  // namespace seamline
