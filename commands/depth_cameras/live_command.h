#pragma once
#include <functional>

#include "live/running/live_request.h"

namespace CLI {
class App;
}

namespace seamline::live {

/// Shows a recording in a window until the person leaves it.
using ShowInWindow = std::function<void(const LiveRequest&)>;

/// `seamline live`: virtual things in a recording, at the rate of a camera. Without `show` (a build without
/// the window) it has `--headless` alone.
void add_live_command(CLI::App& app, const ShowInWindow& show = {});

}  // namespace seamline::live
