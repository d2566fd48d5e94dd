#pragma once
#include <functional>

#include "live/running/live_request.h"

// Depth cameras: what each file of this folder adds to the command line.

namespace CLI {
class App;
}

namespace seamline::registration {

/// `seamline register`: a depth map and a photograph of the user's own, brought together.
void add_register_command(CLI::App& app);

/// `seamline calibrate`: cameras from pictures of a chessboard, a pose from pairs of points.
void add_calibrate_command(CLI::App& app);

}  // namespace seamline::registration

namespace seamline::renderer {

/// `seamline sense`: what a depth camera and its colour camera deliver of a scene.
void add_sense_command(CLI::App& app);

/// `seamline settle`: a body falls on depth, and shakes with it.
void add_settle_command(CLI::App& app);

/// `seamline relight`: a virtual light on measured depth, which flickers.
void add_relight_command(CLI::App& app);

/// The building blocks on the user's own files: `seamline capture`, `seamline mesh`.
void add_workbench_commands(CLI::App& app);

}  // namespace seamline::renderer

namespace seamline::live {

/// `seamline record`: a recording of a scene by a depth camera and its colour camera.
void add_record_command(CLI::App& app);

/// Shows a recording in a window until the person leaves it.
using ShowInWindow = std::function<void(const LiveRequest&)>;

/// `seamline live`: virtual things in a recording, at the rate of a camera. Without `show` (a build without
/// the window) it has `--headless` alone.
void add_live_command(CLI::App& app, const ShowInWindow& show = {});

}  // namespace seamline::live

namespace seamline::sensors {

/// `seamline animate`: recorded joints move the figure of a file.
void add_animate_command(CLI::App& app);

}  // namespace seamline::sensors
