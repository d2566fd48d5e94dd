#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "renderer/depth/dense_sphere.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {

/// Which vertices of the dense sphere a mesh uses, and their compact numbers. A bit for each vertex in tiles
/// of 8 x 8, so that neighbours are near each other in memory, and a running count for each tile: 1.5 bits a
/// vertex where an index table takes 32.
class VertexNumbering {
 public:
  VertexNumbering(int width, int height);

  /// Says that the vertex is used. Safe from several threads.
  void mark(int row, int column);
  /// Gives every marked vertex its number. Returns how many there are.
  std::uint32_t number_marked();
  /// The number of a marked vertex.
  [[nodiscard]] std::uint32_t number(int row, int column) const;
  /// Writes the positions of the marked vertices, in the order of their numbers.
  void write_positions(const DenseSphere& sphere, Eigen::Vector3f* positions_m, int threads) const;

 private:
  [[nodiscard]] std::size_t tile(int row, int column) const {
    return grid_index(row / 8, column / 8, tiles_across_);
  }
  static std::uint64_t bit(int row, int column) {
    return std::uint64_t{1} << static_cast<unsigned>(row % 8 * 8 + column % 8);
  }

  int tiles_across_, tiles_down_;
  std::vector<std::uint64_t> marked_;
  std::vector<std::uint32_t> marked_before_;
};

}  // namespace seamline::renderer
