#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/statistics/estimate.h"

namespace seamline::analysis {

/// The non-increasing values nearest to the data in weighted least squares, and the blocks they are constant
/// on.
struct IsotonicFit {
  std::vector<double> value;             ///< one a level, falling or equal
  std::vector<std::size_t> block_begin;  ///< for each level, the first level of its block
  std::vector<std::size_t> block_end;    ///< for each level, one past the last level of its block
};

/// Non-increasing isotonic regression by pooling adjacent violators (Barlow et al. 1972), all weights equal.
/// Blocks are maximal: neighbouring levels with equal fitted values belong to the same block only when they
/// were pooled.
[[nodiscard]] IsotonicFit fit_non_increasing(std::span<const double> values);

/// The fit between levels: linear in log2 width. `level_x` is rising, `at_x` within its range.
[[nodiscard]] double value_at(std::span<const double> level_x, std::span<const double> fit, double at_x);

/// The threshold functional of the perceptual threshold (level 0.5) and of "slightly noticeable" (level 1.0):
/// the largest log2 width at which the non-increasing curve `fit`, linear between its points, equals `level`.
/// `above_every_level` when every value is above the level (the threshold is beyond the finest map tested),
/// `below_every_level` when every one is below. A flat part exactly at the level counts as equal, so its
/// right end is the answer.
[[nodiscard]] double largest_x_at(double level, std::span<const double> level_x, std::span<const double> fit);

}  // namespace seamline::analysis
