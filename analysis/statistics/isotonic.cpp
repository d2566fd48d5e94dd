#include "analysis/statistics/isotonic.h"

#include <cassert>

namespace seamline::analysis {

namespace {

/// Means of ratings are ratios of small integers; this only undoes the rounding of their sums.
constexpr double level_tolerance = 1e-9;

}  // namespace

IsotonicFit fit_non_increasing(std::span<const double> values) {
  struct Block {
    std::size_t begin = 0;
    double sum = 0;
    double count = 0;
    [[nodiscard]] double mean() const { return sum / count; }
  };
  std::vector<Block> blocks;
  blocks.reserve(values.size());
  for (std::size_t level = 0; level < values.size(); ++level) {
    blocks.push_back({.begin = level, .sum = values[level], .count = 1});
    while (blocks.size() > 1 && blocks.back().mean() > blocks[blocks.size() - 2].mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().sum += last.sum;
      blocks.back().count += last.count;
    }
  }

  IsotonicFit fit;
  fit.value.resize(values.size());
  fit.block_begin.resize(values.size());
  fit.block_end.resize(values.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::size_t end = b + 1 < blocks.size() ? blocks[b + 1].begin : values.size();
    for (std::size_t level = blocks[b].begin; level < end; ++level) {
      fit.value[level] = blocks[b].mean();
      fit.block_begin[level] = blocks[b].begin;
      fit.block_end[level] = end;
    }
  }
  return fit;
}

double value_at(std::span<const double> level_x, std::span<const double> fit, double at_x) {
  assert(!level_x.empty() && level_x.size() == fit.size());
  if (at_x <= level_x.front()) return fit.front();
  for (std::size_t right = 1; right < level_x.size(); ++right) {
    if (at_x > level_x[right]) continue;
    const double t = (at_x - level_x[right - 1]) / (level_x[right] - level_x[right - 1]);
    return (1 - t) * fit[right - 1] + t * fit[right];
  }
  return fit.back();
}

double largest_x_at(double level, std::span<const double> level_x, std::span<const double> fit) {
  assert(!level_x.empty() && level_x.size() == fit.size());
  if (fit.back() > level + level_tolerance) return above_every_level;
  // From the right: the first point at or above the level; the crossing lies between it and its right
  // neighbour.
  for (std::size_t i = fit.size(); i-- > 0;) {
    if (fit[i] < level - level_tolerance) continue;
    if (fit[i] <= level + level_tolerance) return level_x[i];
    const double t = (fit[i] - level) / (fit[i] - fit[i + 1]);
    return level_x[i] + t * (level_x[i + 1] - level_x[i]);
  }
  return below_every_level;
}

}  // namespace seamline::analysis
