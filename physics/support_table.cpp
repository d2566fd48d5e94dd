#include "physics/support_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace seamline::renderer {
namespace {

constexpr double clearly = 1e-12;     ///< nearer than any rounding: of the product of two lengths
constexpr double beyond_cell = 1e-9;  ///< so that rounding puts no direction beside its cell

double along(const Eigen::Vector3d& point_m, const Eigen::Vector3d& direction) {
  return point_m.x() * direction.x() + point_m.y() * direction.y() + point_m.z() * direction.z();
}

std::size_t first_farthest(std::span<const Eigen::Vector3d> points_m, std::span<const std::uint32_t> asked,
                           const Eigen::Vector3d& direction) {
  std::size_t best = 0;
  double best_m = -std::numeric_limits<double>::max();
  for (const std::uint32_t i : asked)
    if (const double reach_m = along(points_m[i], direction); reach_m > best_m) best = i, best_m = reach_m;
  return best;
}

/// A direction on a side of the cube (0 to 5: axis and sign), at (u, v) from -1 to 1.
Eigen::Vector3d on_cube(int side, double u, double v) {
  const int axis = side / 2;
  Eigen::Vector3d direction;
  direction[axis] = side % 2 == 0 ? 1 : -1;
  direction[(axis + 1) % 3] = u;
  direction[(axis + 2) % 3] = v;
  return direction;
}

int cell_on_side(double from_minus_one_to_one, int cells) {
  return std::clamp(static_cast<int>((from_minus_one_to_one + 1) * 0.5 * cells), 0, cells - 1);
}

}  // namespace

SupportTable::SupportTable(std::vector<Eigen::Vector3d> points_m) : points_m_(std::move(points_m)) {
  std::size_t cell = 0;
  for (int side = 0; side < 6; ++side)
    for (int row = 0; row < cells_a_side; ++row)
      for (int column = 0; column < cells_a_side; ++column) {
        const auto border = [](int line) { return 2.0 * line / cells_a_side - 1; };
        const double left = border(column) - beyond_cell, right = border(column + 1) + beyond_cell;
        const double low = border(row) - beyond_cell, high = border(row + 1) + beyond_cell;
        const auto found = candidates({on_cube(side, left, low), on_cube(side, right, low),
                                       on_cube(side, right, high), on_cube(side, left, high)});
        listed_.insert(listed_.end(), found.begin(), found.end());
        first_[++cell] = static_cast<std::uint32_t>(listed_.size());
      }
}

/// A point that is clearly less far than another one along all four corners of a cell is so everywhere in it,
/// because directions in the cell are sums of the corners with positive weights.
std::vector<std::uint32_t> SupportTable::candidates(const std::array<Eigen::Vector3d, 4>& corners) const {
  std::vector<std::uint32_t> all(points_m_.size());
  std::iota(all.begin(), all.end(), 0U);
  std::vector<std::size_t> far;
  for (const Eigen::Vector3d& corner : corners) far.push_back(first_farthest(points_m_, all, corner));
  far.push_back(first_farthest(points_m_, all, corners[0] + corners[2]));
  std::vector<std::uint32_t> left;
  for (const std::uint32_t i : all) {
    const bool is_behind = std::any_of(far.begin(), far.end(), [&](std::size_t other) {
      const double least_m = 2 * clearly * (points_m_[i].norm() + points_m_[other].norm());
      return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector3d& corner) {
        return along(points_m_[other], corner) - along(points_m_[i], corner) > least_m;
      });
    });
    if (!is_behind) left.push_back(i);
  }
  return left;
}

const Eigen::Vector3d& SupportTable::farthest(const Eigen::Vector3d& direction) const {
  int axis = 0;
  const double largest = direction.cwiseAbs().maxCoeff(&axis);
  if (!(largest > 0)) return points_m_.front();
  const int side = 2 * axis + (direction[axis] > 0 ? 0 : 1);
  const int column = cell_on_side(direction[(axis + 1) % 3] / largest, cells_a_side);
  const int row = cell_on_side(direction[(axis + 2) % 3] / largest, cells_a_side);
  const auto cell = static_cast<std::size_t>((side * cells_a_side + row) * cells_a_side + column);
  return points_m_[first_farthest(
      points_m_, std::span(listed_).subspan(first_[cell], first_[cell + 1] - first_[cell]), direction)];
}

}  // namespace seamline::renderer
