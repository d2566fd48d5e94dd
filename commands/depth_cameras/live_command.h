#pragma once
#include "commands/depth_cameras/live_commands.h"

namespace seamline::live {

/// `seamline live`: virtual things in a recording, at the rate of a camera.
void add_live_command(CLI::App& app, const ShowInWindow& show);

}  // namespace seamline::live
