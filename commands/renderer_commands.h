#pragma once
#include "composites/place_request.h"

namespace CLI {
class App;
}

namespace seamline::renderer {

/// Adds the subcommands of `renderer/` to the program. Each is parse, load, compute, write. `in_window` shows
/// the window of `place`; null in builds without one.
void add_renderer_commands(CLI::App& app, PlaceInWindow in_window = nullptr);

/// Adds what `seamline lab` holds of `renderer/`: evidence, and figures of the papers.
void add_lab_commands(CLI::App& lab);

}  // namespace seamline::renderer
