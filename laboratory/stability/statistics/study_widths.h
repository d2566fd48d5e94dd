#pragma once
#include <vector>

namespace seamline::stability {

/// The depth widths of the paper's study.
inline const std::vector<int> widths_px = {64, 128, 256, 512, 1024, 2048, 4096};

}  // namespace seamline::stability
