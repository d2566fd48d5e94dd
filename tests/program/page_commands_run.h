#pragma once
#include <string>
#include <vector>

namespace seamline::page_commands {

/// Does what pages say, one after another, in a fresh folder that holds the inputs which they speak of, and
/// expects every command of `seamline` to end well; what serves or opens a window is begun until it is ready,
/// and stopped. GoogleTest hears of every failure. `pages`: paths from the root of the repository.
void follow_pages(const std::vector<std::string>& pages);

}  // namespace seamline::page_commands
