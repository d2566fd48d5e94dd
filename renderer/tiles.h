#pragma once
#include <algorithm>

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

}  // namespace seamline
