#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace seamline::renderer {

/// Which of some points reaches farthest along a direction. Directions are cells of a cube's faces; each cell
/// keeps the points that may be farthest in one of its directions, so that a hundred points become a few.
class SupportTable {
 public:
  /// At least one point.
  explicit SupportTable(std::vector<Eigen::Vector3d> points_m);

  /// The first point among those with the largest dot product, bit for bit as if all were asked.
  [[nodiscard]] const Eigen::Vector3d& farthest(const Eigen::Vector3d& direction) const;

 private:
  static constexpr int cells_a_side = 8;
  static constexpr std::size_t cell_count = std::size_t{6} * cells_a_side * cells_a_side;

  [[nodiscard]] std::vector<std::uint32_t> candidates(const std::array<Eigen::Vector3d, 4>& corners) const;

  std::vector<Eigen::Vector3d> points_m_;
  std::vector<std::uint32_t> listed_;                  ///< points of all cells, one cell after the other
  std::array<std::uint32_t, cell_count + 1> first_{};  ///< of each cell, in `listed_`
};

}  // namespace seamline::renderer
