#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace seamline::renderer {

/// The sphere of directions divided into the square cells of a cube's faces, on which great circles are
/// straight lines.
namespace cube {

inline constexpr int cells = 256;  ///< along an edge of the cube
inline constexpr std::size_t cell_count = std::size_t{6} * cells * cells;

/// The axis a face lies across, and the axes that its columns and rows run along.
struct Face {
  int index, axis, column_axis, row_axis;
  double sign;
};

inline constexpr Face face(int index) {
  const int axis = index / 2;
  return {index, axis, (axis + 1) % 3, (axis + 2) % 3, index % 2 == 0 ? 1.0 : -1.0};
}

inline std::size_t cell_index(int face_index, int row, int column) {
  return (static_cast<std::size_t>(face_index) * cells + static_cast<std::size_t>(row)) * cells +
         static_cast<std::size_t>(column);
}

/// The cell of a direction of any length but zero.
inline std::size_t cell_of(const Eigen::Vector3f& direction) {
  const Eigen::Array3f size = direction.array().abs();
  int axis = size[1] > size[0] ? 1 : 0;
  axis = size[2] > size[axis] ? 2 : axis;
  const float scale = 0.5F * cells / size[axis];
  const auto along = [&](int k) {
    return std::clamp(static_cast<int>(direction[k] * scale + 0.5F * cells), 0, cells - 1);
  };
  return cell_index(2 * axis + (direction[axis] < 0 ? 1 : 0), along((axis + 2) % 3), along((axis + 1) % 3));
}

/// Whether a triangle seen from the origin may reach a face: not when all its corners, and with them
/// everything between them, are beyond one of the planes that bound the face's pyramid.
inline bool may_reach(const Face& face, const std::array<Eigen::Vector3d, 3>& corners) {
  int left = 0, right = 0, below = 0, above = 0;
  for (const Eigen::Vector3d& corner : corners) {
    const double depth = corner[face.axis] * face.sign * (1 + 1e-6);
    left += corner[face.column_axis] < -depth ? 1 : 0;
    right += corner[face.column_axis] > depth ? 1 : 0;
    below += corner[face.row_axis] < -depth ? 1 : 0;
    above += corner[face.row_axis] > depth ? 1 : 0;
  }
  return left < 3 && right < 3 && below < 3 && above < 3;
}

/// The columns (in x) and rows (in y) of the cells that a triangle may touch.
struct CellRange {
  Eigen::Array2i first, last;
};

/// For a triangle that may reach the face. The whole face, when its outline leaves the half space before it.
inline CellRange range_of(const Face& face, const std::array<Eigen::Vector3d, 3>& corners) {
  Eigen::Array2d low(2, 2), high(-2, -2);
  for (const Eigen::Vector3d& corner : corners) {
    const double depth = corner[face.axis] * face.sign;
    if (depth <= 0) return {{0, 0}, {cells - 1, cells - 1}};
    const Eigen::Array2d at = Eigen::Array2d(corner[face.column_axis], corner[face.row_axis]) / depth;
    low = low.min(at);
    high = high.max(at);
  }
  constexpr double rounding_cells = 0.01;
  const auto cell = [](double at, double more) {
    return std::clamp(static_cast<int>((std::clamp(at, -1.1, 1.1) + 1) * 0.5 * cells + more), 0, cells - 1);
  };
  return {{cell(low[0], -rounding_cells), cell(low[1], -rounding_cells)},
          {cell(high[0], rounding_cells), cell(high[1], rounding_cells)}};
}

/// How a triangle covers a cell.
enum class Cover { none, some, centre };

/// `inward` are the normals of the planes through the origin and each edge; inside the triangle no product
/// with them is negative.
inline Cover cover(const Face& face, const std::array<Eigen::Vector3d, 3>& inward, int row, int column) {
  constexpr double half_cell = 1.01 / cells;
  Eigen::Vector3d centre;
  centre[face.axis] = face.sign;
  centre[face.column_axis] = (column + 0.5) * 2 / cells - 1;
  centre[face.row_axis] = (row + 0.5) * 2 / cells - 1;
  Cover covers = Cover::centre;
  for (const Eigen::Vector3d& n : inward) {
    const double at_centre = n.dot(centre);
    if (at_centre >= 0) continue;
    if (at_centre + half_cell * (std::abs(n[face.column_axis]) + std::abs(n[face.row_axis])) < 0)
      return Cover::none;
    covers = Cover::some;
  }
  return covers;
}

}  // namespace cube
}  // namespace seamline::renderer
