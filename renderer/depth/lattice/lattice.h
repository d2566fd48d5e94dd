#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "renderer/depth/lattice/grid_vertex.h"

namespace seamline::renderer {

struct LatticePoint {
  int x = 0;  ///< to the right as seen from the centre; [0, width], where width may be 0 again
  int y = 0;  ///< down; [0, height]
};

/// A right isosceles triangle of the lattice, its right angle at the apex, anticlockwise as seen from the
/// centre. It is split by the line from the apex to the midpoint of the two others.
struct LatticeTriangle {
  LatticePoint apex, left, right;

  /// Its three corners belong to one cell: it cannot be split.
  [[nodiscard]] bool is_unit() const { return ((left.x + right.x) & 1) != 0; }
  [[nodiscard]] LatticePoint midpoint() const { return {(left.x + right.x) / 2, (left.y + right.y) / 2}; }
};

/// The grid that a lattice is laid over.
struct LatticeGrid {
  int columns = 0;     ///< of vertices
  int rows = 0;        ///< of vertices
  int block = 1;       ///< side of the largest triangles: a power of two
  bool wraps = false;  ///< behind the last column comes the first
};

/// Which triangles of the right-triangulated network are split. The lattice is made of square blocks, in an
/// even number around where it wraps, because the network asks for that; it is laid over the grid, which may
/// have any size (around: any even width), by repeating a column or a row here and there. Repeated ones make
/// cells without area, which the mesh leaves out.
///
/// A split is a bit at the midpoint, shared by the two triangles on both sides. What splits follow from what
/// is a monotone rule, so that the set does not depend on the order in which threads find it.
class Lattice {
 public:
  explicit Lattice(const LatticeGrid& grid);

  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int block_count() const { return width_ / block_ * (height_ / block_); }
  /// Two to a block: 2 b and 2 b + 1 belong to block b.
  [[nodiscard]] int root_count() const { return 2 * block_count(); }
  [[nodiscard]] LatticeTriangle root(int i) const;
  [[nodiscard]] GridVertex grid_vertex(const LatticePoint& p) const {
    return {row_of_[static_cast<std::size_t>(p.y)], column_of_[static_cast<std::size_t>(p.x)]};
  }

  [[nodiscard]] bool is_split_at(const LatticePoint& p) const { return (flags(p) & split) != 0; }
  /// Splits the two triangles that meet in this midpoint, and first the larger ones that must be split for
  /// these to exist.
  void split_at(const LatticePoint& p);
  /// The midpoints that `split_at` would split, this one and those of the larger triangles, each once, put
  /// behind what is in `out`.
  void list_splits(const LatticePoint& p, std::vector<LatticePoint>& out) const;
  /// The triangles that meet in a midpoint: two, or one on the border; of a wrap with columns in [0, width].
  [[nodiscard]] std::vector<LatticeTriangle> triangles_of(const LatticePoint& midpoint) const;
  /// Whether something was split in the block, or on its edge, since this was last asked; at first true.
  [[nodiscard]] bool take_change(int block) {
    return std::atomic_ref<std::uint8_t>(changed_[static_cast<std::size_t>(block)])
               .exchange(0, std::memory_order_acquire) != 0;
  }
  /// Notes that the triangle holds its bound, which need not be found out again.
  void accept(const LatticeTriangle& t);
  [[nodiscard]] bool is_accepted(const LatticeTriangle& t) const {
    return (flags(t.midpoint()) & accepted_bit(t)) != 0;
  }

  /// Calls leaf(triangle) for each triangle under this one that is not split, in an order that follows the
  /// surface.
  template <class Leaf>
  void for_each_leaf(const LatticeTriangle& t, const Leaf& leaf) const {
    if (t.is_unit() || !is_split_at(t.midpoint())) return leaf(t);
    const LatticePoint m = t.midpoint();
    for_each_leaf({m, t.apex, t.left}, leaf);
    for_each_leaf({m, t.right, t.apex}, leaf);
  }

 private:
  static constexpr std::uint8_t split = 1, accepted_first = 2, accepted_second = 4;

  static std::uint8_t accepted_bit(const LatticeTriangle& t) {
    const LatticePoint m = t.midpoint();
    return t.apex.y < m.y || (t.apex.y == m.y && t.apex.x < m.x) ? accepted_first : accepted_second;
  }
  [[nodiscard]] std::size_t index(const LatticePoint& p) const {
    const int x = p.x == stride_ ? 0 : p.x;  // never without a wrap
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(stride_) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] std::uint8_t flags(const LatticePoint& p) const {
    return std::atomic_ref<std::uint8_t>(flags_[index(p)]).load(std::memory_order_relaxed);
  }

  void note_change(const LatticePoint& p);
  /// Of the two triangles that meet in a midpoint; not yet brought into the lattice.
  [[nodiscard]] static std::array<LatticePoint, 2> apexes_of(const LatticePoint& midpoint);
  [[nodiscard]] bool is_inside(const LatticePoint& p) const {
    return p.y >= 0 && p.y <= height_ && (wraps_ || (p.x >= 0 && p.x <= width_));
  }
  [[nodiscard]] LatticePoint wrapped(const LatticePoint& p) const {
    return {wraps_ ? (p.x + width_) % width_ : p.x, p.y};
  }
  /// A corner of blocks is always there.
  [[nodiscard]] bool is_corner(const LatticePoint& p) const {
    const int step = (p.x | p.y) & -(p.x | p.y);
    return step == 0 || step >= block_;
  }

  bool wraps_;
  int block_, width_, height_;
  int stride_;  ///< columns that are stored
  std::vector<int> column_of_,
      row_of_;  ///< the grid's column (of a wrap the last is its width) and row of each line of the lattice
  std::vector<std::uint8_t> changed_;        ///< a flag a block
  mutable std::vector<std::uint8_t> flags_;  ///< mutable only because std::atomic_ref cannot be const
};

}  // namespace seamline::renderer
