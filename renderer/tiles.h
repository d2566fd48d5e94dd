#pragma once
#include <algorithm>
#include <vector>

namespace seamline {

/// The picture cut into squares: what a worker takes at a time, what has a number of samples of its own, and
/// over which the worst error is looked for (`--error`: 3 E in the worst of them).
struct TileGrid {
  static constexpr int side_px = 32;
  int width_px = 0, height_px = 0;

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
  [[nodiscard]] int tile_of(int x, int y) const { return (y / side_px) * columns() + x / side_px; }
  [[nodiscard]] Rectangle rectangle(int tile) const {
    const int left = tile % columns() * side_px, top = tile / columns() * side_px;
    return {left, top, std::min(left + side_px, width_px), std::min(top + side_px, height_px)};
  }
  [[nodiscard]] int pixels(int tile) const {
    const Rectangle r = rectangle(tile);
    return (r.right - r.left) * (r.bottom - r.top);
  }
  /// The tile's share of the picture.
  [[nodiscard]] double share(int tile) const {
    return pixels(tile) / (static_cast<double>(width_px) * height_px);
  }
  /// Place of a pixel inside its tile.
  [[nodiscard]] static int place(int x, int y) { return (y % side_px) * side_px + x % side_px; }
};

/// Some tiles of a grid: a flag each.
using TileSet = std::vector<char>;

/// The tiles and the eight around each of them.
[[nodiscard]] inline TileSet with_neighbours(const TileGrid& grid, const TileSet& tiles) {
  TileSet out(tiles.size(), 0);
  for (int tile = 0; tile < grid.count(); ++tile) {
    if (tiles[static_cast<std::size_t>(tile)] == 0) continue;
    const int column = tile % grid.columns(), row = tile / grid.columns();
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows() - 1); ++r)
      for (int c = std::max(column - 1, 0); c <= std::min(column + 1, grid.columns() - 1); ++c)
        out[static_cast<std::size_t>(r * grid.columns() + c)] = 1;
  }
  return out;
}

}  // namespace seamline
