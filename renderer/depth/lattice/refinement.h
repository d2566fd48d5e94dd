#pragma once
#include <algorithm>
#include <vector>

#include "renderer/depth/lattice/lattice.h"
#include "support/running/parallel.h"

namespace seamline::renderer {

// A lattice is refined from coarse to fine until each triangle holds its bound, which is anything with
// `holds(GridTriangle)` and `largest_error(GridTriangle)`.

inline GridTriangle grid_triangle(const Lattice& lattice, const LatticeTriangle& t) {
  return {lattice.grid_vertex(t.apex), lattice.grid_vertex(t.left), lattice.grid_vertex(t.right)};
}

/// Splits what must be split under this triangle.
template <class Bound>
void refine(Lattice& lattice, const Bound& bound, const LatticeTriangle& t) {
  if (t.is_unit()) return;
  const LatticePoint m = t.midpoint();
  if (!lattice.is_split_at(m)) {
    if (lattice.is_accepted(t)) return;
    if (bound.holds(grid_triangle(lattice, t))) {
      lattice.accept(t);
      return;
    }
    lattice.split_at(m);
  }
  refine(lattice, bound, {m, t.apex, t.left});
  refine(lattice, bound, {m, t.right, t.apex});
}

/// A split on one side of an edge can split a triangle that was accepted, on the other side; what that leaves
/// has to be looked at too: in most rounds of few blocks.
template <class Bound>
void refine_all(Lattice& lattice, const Bound& bound, int threads) {
  const auto changed_blocks = [&] {
    std::vector<int> changed;
    for (int block = 0; block < lattice.block_count(); ++block)
      if (lattice.take_change(block)) changed.push_back(block);
    return changed;
  };
  for (std::vector<int> blocks = changed_blocks(); !blocks.empty(); blocks = changed_blocks())
    run_parallel(2 * static_cast<int>(blocks.size()), threads,
                 [&](int i) { refine(lattice, bound, lattice.root(2 * blocks[i / 2] + i % 2)); });
}

/// The largest error under any triangle that was not split; those of one cell have none.
template <class Bound>
double largest_error(const Lattice& lattice, const Bound& bound, int threads) {
  std::vector<double> errors(static_cast<std::size_t>(lattice.root_count()));
  run_parallel(lattice.root_count(), threads, [&](int root) {
    lattice.for_each_leaf(lattice.root(root), [&](const LatticeTriangle& t) {
      if (t.is_unit()) return;
      double& error = errors[root];
      error = std::max(error, bound.largest_error(grid_triangle(lattice, t)));
    });
  });
  return *std::max_element(errors.begin(), errors.end());
}

/// Half a cell: out(a, b, c), each as `vertex` makes it of a LatticePoint. When the other half is a leaf too,
/// the cell is parted as in a full mesh, by the diagonal from its upper left to its lower right corner,
/// whatever the lattice's own is.
template <class Vertex, class Out>
void write_unit(const Lattice& lattice, const LatticeTriangle& t, const Vertex& vertex, const Out& out) {
  const LatticePoint other{t.left.x + t.right.x - t.apex.x, t.left.y + t.right.y - t.apex.y};
  const GridVertex apex = lattice.grid_vertex(t.apex), opposite = lattice.grid_vertex(other);
  if (apex.row == opposite.row || apex.column == opposite.column) return;  // a repeated row or column
  if (!lattice.is_split_at(other)) return out(vertex(t.apex), vertex(t.left), vertex(t.right));
  const auto [left, right] = std::minmax(t.apex.x, other.x);
  const auto [top, bottom] = std::minmax(t.apex.y, other.y);
  const auto nw = vertex({left, top}), se = vertex({right, bottom});
  if (t.apex.x == left)
    out(nw, vertex({left, bottom}), se);
  else
    out(nw, se, vertex({right, top}));
}

}  // namespace seamline::renderer
