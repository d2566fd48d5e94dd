#pragma once
#include <algorithm>
#include <cmath>

#include "support/text/numbers.h"

namespace seamline::stability {

/// The larger of two errors; NaN wins over everything, which std::max does not promise.
[[nodiscard]] inline double worse(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? nan : std::max(a, b);
}

/// |found - expected| / |expected|.
[[nodiscard]] inline double relative_error(double found, double expected) {
  return std::abs(found - expected) / std::abs(expected);
}

}  // namespace seamline::stability
