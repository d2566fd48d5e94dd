#pragma once
#include <vector>

namespace seamline::test {

/// log2 of the paper's widths in px.
inline const std::vector<double> octaves = {6, 7, 8, 9, 10, 11, 12};

}  // namespace seamline::test
