#include "renderer/depth/sensor/pixel_bound.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "renderer/depth/lattice/grid_triangle_cells.h"

namespace seamline::renderer {
namespace {

Eigen::Vector2d centre_px(const GridVertex& v) {
  return {v.column + 0.5, v.row + 0.5};
}

}  // namespace

PixelBound::PixelBound(const PixelGrid& grid, double tolerance, const std::optional<double>& cut_ratio)
    : grid_(grid), cut_ratio_(cut_ratio) {
  const double e = std::max(0.0, tolerance) * (1 - 1e-9);
  smallest_q_ = 1 / (1 + e);
  largest_q_ = e < 1 ? 1 / (1 - e) : std::numeric_limits<double>::max();
}

bool PixelBound::within(const Spread& spread) const {
  return spread.smallest >= smallest_q_ && spread.largest <= largest_q_;
}

bool PixelBound::holds(const GridTriangle& t) const {
  // Repeated columns or rows can leave a triangle without area; it must be split until nothing is left of it.
  const int area = (t[1].column - t[0].column) * (t[2].row - t[0].row) -
                   (t[2].column - t[0].column) * (t[1].row - t[0].row);
  if (area == 0) return false;
  const auto holes = std::count_if(t.begin(), t.end(), [&](const GridVertex& v) { return !grid_.valid(v); });
  if (holes > 0) return holes == 3 && is_one_hole(t);
  return within(spread_under(t)) && !(cut_ratio_ && jumps_under(t));
}

/// Between neighbours along rows and columns; all pixels under the triangle were measured.
bool PixelBound::jumps_under(const GridTriangle& t) const {
  const int bottom = std::max({t[0].row, t[1].row, t[2].row});
  bool jumps = false;
  for_each_row(t, [&](int row, int first, int last) {
    for (int column = first; column <= last; ++column) {
      const double here_m = grid_.seen_m({row, column}).norm();
      const auto jumps_to = [&](const GridVertex& other) {
        return is_jump(here_m, here_m, grid_.seen_m(other).norm(), *cut_ratio_);
      };
      jumps = jumps || (column < last && jumps_to({row, column + 1})) ||
              (row < bottom && jumps_to({row + 1, column}));
    }
    return !jumps;
  });
  return jumps;
}

double PixelBound::largest_error(const GridTriangle& t) const {
  if (!grid_.valid(t[0])) return 0;
  const Spread spread = spread_under(t);
  return std::max(1 / spread.smallest - 1, 1 - 1 / spread.largest);
}

bool PixelBound::is_one_hole(const GridTriangle& t) const {
  const auto [top, bottom] = std::minmax({t[0].row, t[1].row, t[2].row});
  const auto [left, right] = std::minmax({t[0].column, t[1].column, t[2].column});
  for (int row = top; row <= bottom; ++row)
    for (int column = left; column <= right; ++column)
      if (grid_.valid({row, column})) return false;
  return true;
}

/// How far an edge's middle lies from the grid's line, rounded up with half as much again.
int PixelBound::straying_px(const GridTriangle& t) const {
  if (grid_.camera.distortion.is_none()) return 0;
  double most_px = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector2d a_px = centre_px(t[i]), b_px = centre_px(t[(i + 1) % 3]);
    const auto a = sensors::direction_through(grid_.camera, a_px),
               b = sensors::direction_through(grid_.camera, b_px);
    if (!a || !b) return grid_.camera.width_px;
    const auto middle_px = sensors::project(grid_.camera, 0.5 * (*a + *b));
    if (!middle_px) return grid_.camera.width_px;
    most_px = std::max(most_px, (*middle_px - 0.5 * (a_px + b_px)).norm());
  }
  return static_cast<int>(std::ceil(1.5 * most_px - 1e-6));
}

/// The spread of n.p under the triangle; where it leaves the bound, the rest is not looked at.
PixelBound::Spread PixelBound::spread_under(const GridTriangle& t) const {
  Spread spread;
  const std::array<Eigen::Vector3d, 3> p = {grid_.seen_m(t[0]), grid_.seen_m(t[1]), grid_.seen_m(t[2])};
  const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
  const Eigen::Vector3d n = normal / normal.dot(p[0]);
  if (!n.allFinite()) return {.smallest = 0};
  const auto add = [&](int row, int column) {
    if (!grid_.valid({row, column})) {
      spread.smallest = 0;
      return;
    }
    const double q = n.dot(grid_.seen_m({row, column}));
    spread.smallest = std::min(spread.smallest, q);
    spread.largest = std::max(spread.largest, q);
  };
  // Most triangles that fail, fail at the middle of the longest edge.
  add((t[1].row + t[2].row) / 2, (t[1].column + t[2].column) / 2);
  if (!within(spread)) return spread;

  const int beside = straying_px(t);
  const int last_row = grid_.camera.height_px - 1, last_column = grid_.camera.width_px - 1;
  for_each_row(t, [&](int row, int first, int last) {
    for (int y = std::max(0, row - beside); y <= std::min(last_row, row + beside); ++y)
      for (int x = std::max(0, first - beside); x <= std::min(last_column, last + beside); ++x) add(y, x);
    return within(spread);
  });
  return spread;
}

}  // namespace seamline::renderer
