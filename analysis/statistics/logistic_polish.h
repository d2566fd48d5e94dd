#pragma once
#include <cmath>

namespace seamline::analysis {

/// 1 far below 0, 0 far above.
[[nodiscard]] inline double falling_logistic(double z) {
  return 1 / (1 + std::exp(z));
}

/// How long the fit of a logistic is polished by Gauss-Newton steps.
struct LogisticPolish {
  static constexpr int most_steps = 60;
  static constexpr double smallest_move = 1e-7;  ///< octaves and ln scale
};

}  // namespace seamline::analysis
