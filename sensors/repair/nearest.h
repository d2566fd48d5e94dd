#pragma once
#include "sensors/repair/repaired.h"

namespace seamline::sensors {

/// Fills every hole with the value of the measured pixel nearest to it in the picture, over the whole
/// picture, as paper 002 (section 4) does: exact Euclidean distance between pixel centres; of several at the
/// same distance the one in the higher row, then farther left. Measured pixels are kept. A frame of holes
/// alone stays as it is. The same bytes for any number of threads (0: one for each core).
[[nodiscard]] Repaired fill_with_nearest(const DepthFrame& measured, int threads = 0);

}  // namespace seamline::sensors
