#pragma once
#include <CLI/CLI.hpp>
#include <initializer_list>

namespace seamline {

/// Before a command works: proves that the files which these options name can be written, and are none of
/// those that its other options name (`require_outputs` of support/). Options that were not given say
/// nothing.
void require_outputs(const CLI::App& command, std::initializer_list<const char*> outputs);

}  // namespace seamline
