#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

#include "renderer/depth/lattice/grid_vertex.h"

namespace seamline::renderer {

// Which cells of a grid a triangle covers.

/// The columns of each row that belong to cells the triangle covers, at least in part: visit(row, first,
/// last) until it says false.
void for_each_row(const GridTriangle& t, auto visit) {
  std::array<GridVertex, 3> v = t;
  std::sort(v.begin(), v.end(), [](const GridVertex& a, const GridVertex& b) { return a.row < b.row; });
  const auto along = [](const GridVertex& from, const GridVertex& to, int row) {
    return from.column +
           static_cast<double>((to.column - from.column) * (row - from.row)) / (to.row - from.row);
  };
  struct Span {
    double left, right;
  };
  const auto span = [&](int row) {
    const double whole = along(v[0], v[2], row);
    const double part = row == v[1].row  ? v[1].column
                        : row < v[1].row ? along(v[0], v[1], row)
                                         : along(v[1], v[2], row);
    return Span{std::min(whole, part), std::max(whole, part)};
  };
  constexpr double rounding = 1e-9;
  Span before = span(v[0].row), here = before;
  for (int row = v[0].row; row <= v[2].row; ++row) {
    const Span after = row < v[2].row ? span(row + 1) : here;
    const double left = std::min({before.left, here.left, after.left});
    const double right = std::max({before.right, here.right, after.right});
    if (!visit(row, static_cast<int>(left + rounding), static_cast<int>(right + 1 - rounding))) return;
    before = here;
    here = after;
  }
}

/// Calls visit(first, count) for the runs of stored columns that make up the columns first .. last,
/// which may pass the seam.
void for_each_run(int first, int last, int width, auto visit) {
  while (first <= last) {
    const int start = first >= width ? first - width : first;
    const int count = std::min(last - first + 1, width - start);
    visit(static_cast<std::size_t>(start), count);
    first += count;
  }
}

}  // namespace seamline::renderer
