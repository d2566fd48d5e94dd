#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace seamline::renderer {

/// Of a panorama's row: its pixels' solid angle over the mean of all rows. The sum over the rows is their
/// number. A panorama is twice as wide as high: in a higher picture several stand one above the other.
[[nodiscard]] inline double panorama_row_weight(int y, int width_px, int height_px) {
  const int rows = std::min(height_px, std::max(1, width_px / 2));
  const double half_row_rad = 0.5 * std::numbers::pi / rows;
  return rows * std::sin(half_row_rad) * std::sin((2 * (y % rows) + 1) * half_row_rad);
}

/// The picture cut into squares.
template <int side>
struct SquareGrid {
  static constexpr int side_px = side;
  int width_px = 0, height_px = 0;
  /// Of a panorama, whose width is a multiple of the tiles' side: its last column stands beside its first,
  /// and its rows count by their solid angle.
  bool wraps = false;

  struct Rectangle {
    int left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom are outside
  };

  [[nodiscard]] int columns() const { return (width_px + side_px - 1) / side_px; }
  [[nodiscard]] int rows() const { return (height_px + side_px - 1) / side_px; }
  [[nodiscard]] int count() const { return columns() * rows(); }
  /// Place of a pixel in the picture, row by row.
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x);
  }
  /// Number of the square that a pixel lies in.
  [[nodiscard]] int square_of(int x, int y) const { return (y / side_px) * columns() + x / side_px; }
  [[nodiscard]] Rectangle rectangle(int square) const {
    const int left = square % columns() * side_px, top = square / columns() * side_px;
    return {left, top, std::min(left + side_px, width_px), std::min(top + side_px, height_px)};
  }
  [[nodiscard]] int pixels(int square) const {
    const Rectangle r = rectangle(square);
    return (r.right - r.left) * (r.bottom - r.top);
  }
  /// As many pixels of mean weight as the square is worth.
  [[nodiscard]] double weight(int square) const {
    if (!wraps) return pixels(square);
    const Rectangle r = rectangle(square);
    double rows = 0;
    for (int y = r.top; y < r.bottom; ++y) rows += panorama_row_weight(y, width_px, height_px);
    return rows * (r.right - r.left);
  }
  /// The square's share of the picture.
  [[nodiscard]] double share(int square) const {
    return weight(square) / (static_cast<double>(width_px) * height_px);
  }
  /// Place of a pixel inside its square.
  [[nodiscard]] static int place(int x, int y) { return (y % side_px) * side_px + x % side_px; }
};

/// What a worker takes at a time, what an object's sums are kept for, and over which the worst error is
/// looked for (`--error`: 3 E in the worst of them).
using TileGrid = SquareGrid<32>;
/// What has a number of samples of its own: a quarter of a tile, so that samples go where the noise is.
using BlockGrid = SquareGrid<16>;

/// The blocks of a tile.
[[nodiscard]] inline std::vector<int> blocks_of(const TileGrid& grid, int tile) {
  static_assert(TileGrid::side_px % BlockGrid::side_px == 0);
  const BlockGrid blocks{grid.width_px, grid.height_px};
  const TileGrid::Rectangle r = grid.rectangle(tile);
  std::vector<int> out;
  for (int y = r.top; y < r.bottom; y += BlockGrid::side_px)
    for (int x = r.left; x < r.right; x += BlockGrid::side_px) out.push_back(blocks.square_of(x, y));
  return out;
}

/// The tile that a block lies in.
[[nodiscard]] inline int tile_of_block(const TileGrid& grid, int block) {
  const BlockGrid::Rectangle r = BlockGrid{grid.width_px, grid.height_px}.rectangle(block);
  return grid.square_of(r.left, r.top);
}

/// Some tiles of a grid: a flag each.
using TileSet = std::vector<char>;

/// Calls `take` with a square and each of the eight around it that there are, row by row.
template <int side, class Take>
void each_neighbour(const SquareGrid<side>& grid, int square, const Take& take) {
  const int column = square % grid.columns(), row = square / grid.columns();
  const int columns = grid.columns(), left = column - (grid.wraps || column > 0 ? 1 : 0),
            right = column + (grid.wraps || column + 1 < columns ? 1 : 0);
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows() - 1); ++r)
    for (int c = left; c <= right; ++c) {
      const int there = r * columns + (c + columns) % columns;
      take(static_cast<std::size_t>(there));
    }
}

/// The tiles and the eight around each of them.
[[nodiscard]] inline TileSet with_neighbours(const TileGrid& grid, const TileSet& tiles) {
  TileSet out(tiles.size(), 0);
  for (int tile = 0; tile < grid.count(); ++tile)
    if (tiles[static_cast<std::size_t>(tile)] != 0)
      each_neighbour(grid, tile, [&](std::size_t neighbour) { out[neighbour] = 1; });
  return out;
}

}  // namespace seamline::renderer
