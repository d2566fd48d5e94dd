#pragma once
#include "live/running/live_request.h"

namespace seamline::live {

/// Plays a recording with virtual things in a window, at the recording's own rate or as fast as frames can be
/// made, with the time of each stage beside the picture. Keys switch methods. Until the person leaves, or
/// `request.frames` were shown. Throws InputError where there is no screen, and as the readers do.
void show_live(const LiveRequest& request);

}  // namespace seamline::live
