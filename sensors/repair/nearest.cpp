#include "sensors/repair/nearest.h"

#include <limits>

#include "support/running/parallel.h"

namespace seamline::sensors {
namespace {

constexpr std::int64_t nowhere = std::numeric_limits<std::int64_t>::max();

/// For each pixel, the row of the nearest measured pixel of its own column (the upper of two); -1: none.
std::vector<int> nearest_rows(const DepthFrame& frame) {
  const int width = frame.camera.width_px, height = frame.camera.height_px;
  std::vector<int> rows(frame.depth_m.size(), -1);
  for (int column = 0; column < width; ++column) {
    for (int row = 0, last = -1; row < height; ++row) {
      if (!DepthFrame::is_hole(frame.at(column, row))) last = row;
      rows[frame.index(column, row)] = last;
    }
    for (int row = height - 1, last = -1; row >= 0; --row) {
      if (!DepthFrame::is_hole(frame.at(column, row))) last = row;
      int& nearest = rows[frame.index(column, row)];
      if (last >= 0 && (nearest < 0 || last - row < row - nearest)) nearest = last;
    }
  }
  return rows;
}

/// The nearest measured pixel's value: column after column to both sides, for as long as a column can hold
/// one that is not farther.
float nearest_value(const DepthFrame& frame, const std::vector<int>& rows, int column, int row) {
  std::int64_t best = nowhere;
  int best_row = 0, best_column = 0;
  const auto look = [&](int other, std::int64_t aside) {
    if (other < 0 || other >= frame.camera.width_px) return;
    const int found = rows[frame.index(other, row)];
    if (found < 0) return;
    const std::int64_t above = found - row, square = aside * aside + above * above;
    if (square > best) return;
    if (square == best && (found > best_row || (found == best_row && other > best_column))) return;
    best = square;
    best_row = found;
    best_column = other;
  };
  for (int aside = 0; aside < frame.camera.width_px && std::int64_t{aside} * aside <= best; ++aside) {
    look(column - aside, aside);
    look(column + aside, aside);
  }
  return best == nowhere ? hole : frame.at(best_column, best_row);
}

}  // namespace

Repaired fill_with_nearest(const DepthFrame& measured, int threads) {
  const std::vector<int> rows = nearest_rows(measured);
  std::vector<float> depth_m = measured.depth_m;
  run_parallel(measured.camera.height_px, threads, [&](int row) {
    for (int column = 0; column < measured.camera.width_px; ++column)
      if (DepthFrame::is_hole(measured.at(column, row)))
        depth_m[measured.index(column, row)] = nearest_value(measured, rows, column, row);
  });
  return repaired_frame(measured, std::move(depth_m));
}

}  // namespace seamline::sensors
