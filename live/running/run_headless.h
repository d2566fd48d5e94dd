#pragma once
#include "live/running/live_request.h"

namespace seamline::live {

/// Composes the frames without a window: writes N.png (of several views N_V.png, from the left) into
/// `request.out`, the times into `request.csv`, and prints medians of the times.
void run_headless(const LiveRequest& request);

}  // namespace seamline::live
