#pragma once
#include <Eigen/Core>
#include <vector>

#include "analysis/statistics/logistic4.h"

namespace seamline::analysis {

/// The least-squares logistic among those that equal a level at a width: what the data look like if that
/// width were the threshold.
struct LogisticThroughLevel {
  Logistic4 curve;
  double residual_sum_of_squares = 0;
};

/// Fits y(x) = level + fall (F((x - centre) / scale) - F((w - centre) / scale)), F the falling logistic, fall
/// at least 0, centre and scale within `box`: from the best of a coarse grid and, when it is given, from a
/// curve that fitted nearby (`start`). `level_x` is rising, `means` has one value a width.
[[nodiscard]] LogisticThroughLevel fit_through_level(double level, double at_x,
                                                     const std::vector<double>& level_x,
                                                     const Eigen::VectorXd& means, const LogisticBox& box,
                                                     const Logistic4* start = nullptr);

}  // namespace seamline::analysis
