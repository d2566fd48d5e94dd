#pragma once
#include <string>

#include "live/running/live_request.h"

namespace seamline::live {

/// Composes the frames without a window: writes N.png (of several views N_V.png, from the left) into
/// `request.out` and the times into `request.csv`. Returns lines of text: what was drawn, medians of the
/// times, and where bodies came to rest.
[[nodiscard]] std::string run_headless(const LiveRequest& request);

}  // namespace seamline::live
