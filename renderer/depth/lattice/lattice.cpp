#include "renderer/depth/lattice/lattice.h"

#include <algorithm>
#include <array>

namespace seamline::renderer {
namespace {

/// Spreads dense lines 0 .. last over lattice lines 0 .. count, by rounding: fewer than two lattice lines to
/// each dense one.
std::vector<int> spread(int count, int last) {
  std::vector<int> line(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i <= count; ++i)
    line[static_cast<std::size_t>(i)] =
        static_cast<int>((std::int64_t{2} * i * last + count) / (std::int64_t{2} * count));
  return line;
}

int round_up(int value, int step) {
  return (value + step - 1) / step * step;
}

}  // namespace

Lattice::Lattice(const LatticeGrid& grid)
    : wraps_(grid.wraps),
      block_(grid.block),
      width_(grid.wraps ? round_up(grid.columns, 2 * block_)
                        : round_up(std::max(1, grid.columns - 1), block_)),
      height_(round_up(std::max(1, grid.rows - 1), block_)),
      stride_(grid.wraps ? width_ : width_ + 1),
      column_of_(spread(width_, grid.wraps ? grid.columns : grid.columns - 1)),
      row_of_(spread(height_, grid.rows - 1)),
      changed_(static_cast<std::size_t>(block_count()), 1),
      flags_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height_ + 1)) {}

LatticeTriangle Lattice::root(int i) const {
  const int blocks_across = width_ / block_;
  const int column = i / 2 % blocks_across, row = i / 2 / blocks_across;
  const LatticePoint nw{column * block_, row * block_}, se{nw.x + block_, nw.y + block_};
  const LatticePoint ne{se.x, nw.y}, sw{nw.x, se.y};
  if ((column + row) % 2 == 0) return i % 2 == 0 ? LatticeTriangle{sw, se, nw} : LatticeTriangle{ne, nw, se};
  return i % 2 == 0 ? LatticeTriangle{nw, sw, ne} : LatticeTriangle{se, ne, sw};
}

void Lattice::split_at(const LatticePoint& p) {
  const int step = (p.x | p.y) & -(p.x | p.y);  // the largest power of two that divides both
  if (step == 0 || step >= block_) return;      // a corner of blocks is always there
  std::atomic_ref<std::uint8_t> flags(flags_[index(p)]);
  if ((flags.fetch_or(split, std::memory_order_relaxed) & split) != 0) return;
  note_change(p);

  // The two triangles that share this midpoint exist when their larger parents are split, whose midpoints are
  // their apexes.
  std::array<LatticePoint, 2> apexes;
  if ((p.x & step) == 0)  // on a vertical edge
    apexes = {LatticePoint{p.x - step, p.y}, LatticePoint{p.x + step, p.y}};
  else if ((p.y & step) == 0)  // on a horizontal edge
    apexes = {LatticePoint{p.x, p.y - step}, LatticePoint{p.x, p.y + step}};
  else if ((((p.x - step) ^ (p.y - step)) & (2 * step)) == 0)  // on a diagonal from upper left to lower right
    apexes = {LatticePoint{p.x + step, p.y - step}, LatticePoint{p.x - step, p.y + step}};
  else
    apexes = {LatticePoint{p.x - step, p.y - step}, LatticePoint{p.x + step, p.y + step}};
  for (const LatticePoint& apex : apexes)
    if (apex.y >= 0 && apex.y <= height_ && (wraps_ || (apex.x >= 0 && apex.x <= width_)))
      split_at({wraps_ ? (apex.x + width_) % width_ : apex.x, apex.y});
}

void Lattice::note_change(const LatticePoint& p) {
  const int across = width_ / block_, down = height_ / block_;
  const int right = wraps_ ? p.x / block_ % across : p.x / block_, below = p.y / block_;
  int left = p.x % block_ == 0 ? right - 1 : right;
  if (wraps_ && left < 0) left = across - 1;
  const int above = p.y % block_ == 0 ? below - 1 : below;
  for (const int row : {above, below})
    for (const int column : {left, right})
      if (row >= 0 && row < down && column >= 0 && column < across)
        std::atomic_ref<std::uint8_t>(changed_[static_cast<std::size_t>(row * across + column)])
            .store(1, std::memory_order_release);
}

void Lattice::accept(const LatticeTriangle& t) {
  std::atomic_ref<std::uint8_t>(flags_[index(t.midpoint())])
      .fetch_or(accepted_bit(t), std::memory_order_relaxed);
}

}  // namespace seamline::renderer
