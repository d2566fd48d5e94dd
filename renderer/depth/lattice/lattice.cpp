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
    line[i] = static_cast<int>((std::int64_t{2} * i * last + count) / (std::int64_t{2} * count));
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

std::array<LatticePoint, 2> Lattice::apexes_of(const LatticePoint& p) {
  const int step = (p.x | p.y) & -(p.x | p.y);  // the largest power of two that divides both
  if ((p.x & step) == 0)                        // on a vertical edge
    return {LatticePoint{p.x - step, p.y}, LatticePoint{p.x + step, p.y}};
  if ((p.y & step) == 0)  // on a horizontal edge
    return {LatticePoint{p.x, p.y - step}, LatticePoint{p.x, p.y + step}};
  if ((((p.x - step) ^ (p.y - step)) & (2 * step)) == 0)  // on a diagonal from upper left to lower right
    return {LatticePoint{p.x + step, p.y - step}, LatticePoint{p.x - step, p.y + step}};
  return {LatticePoint{p.x - step, p.y - step}, LatticePoint{p.x + step, p.y + step}};
}

void Lattice::split_at(const LatticePoint& p) {
  if (is_corner(p)) return;
  std::atomic_ref<std::uint8_t> flags(flags_[index(p)]);
  if ((flags.fetch_or(split, std::memory_order_relaxed) & split) != 0) return;
  note_change(p);

  // The two triangles that share this midpoint exist when their larger parents are split, whose midpoints are
  // their apexes.
  for (const LatticePoint& apex : apexes_of(p))
    if (is_inside(apex)) split_at(wrapped(apex));
}

void Lattice::list_splits(const LatticePoint& p, std::vector<LatticePoint>& out) const {
  const auto is_listed = [&](const LatticePoint& q) {
    return std::any_of(out.begin(), out.end(),
                       [&](const LatticePoint& o) { return o.x == q.x && o.y == q.y; });
  };
  if (is_corner(p) || is_split_at(p) || is_listed(p)) return;
  out.push_back(p);
  for (const LatticePoint& apex : apexes_of(p))
    if (is_inside(apex)) list_splits(wrapped(apex), out);
}

std::vector<LatticeTriangle> Lattice::triangles_of(const LatticePoint& midpoint) const {
  std::vector<LatticeTriangle> triangles;
  for (const LatticePoint& apex : apexes_of(midpoint)) {
    if (!is_inside(apex)) continue;
    const LatticePoint d{apex.x - midpoint.x, apex.y - midpoint.y};
    LatticeTriangle t{apex, {midpoint.x + d.y, midpoint.y - d.x}, {midpoint.x - d.y, midpoint.y + d.x}};
    const int least = std::min({t.apex.x, t.left.x, t.right.x});
    const int shift = least < 0                                                      ? width_
                      : wraps_ && std::max({t.apex.x, t.left.x, t.right.x}) > width_ ? -width_
                                                                                     : 0;
    for (LatticePoint* corner : {&t.apex, &t.left, &t.right}) corner->x += shift;
    triangles.push_back(t);
  }
  return triangles;
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
