#include "renderer/depth/adaptive_mesh.h"

#include <algorithm>

#include "renderer/depth/adaptive_mesh_assembly.h"
#include "renderer/depth/adaptive_mesh_bound.h"
#include "renderer/depth/adaptive_mesh_lattice.h"
#include "support/running/parallel.h"

namespace seamline::renderer {
namespace {

GridTriangle grid_triangle(const Lattice& lattice, const LatticeTriangle& t) {
  return {lattice.grid_vertex(t.apex), lattice.grid_vertex(t.left), lattice.grid_vertex(t.right)};
}

/// Splits what must be split under this triangle.
void refine(Lattice& lattice, const TriangleBound& bound, const LatticeTriangle& t) {
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
void refine_all(Lattice& lattice, const TriangleBound& bound, int threads) {
  const auto changed_blocks = [&] {
    std::vector<int> changed;
    for (int block = 0; block < lattice.block_count(); ++block)
      if (lattice.take_change(block)) changed.push_back(block);
    return changed;
  };
  for (std::vector<int> blocks = changed_blocks(); !blocks.empty(); blocks = changed_blocks())
    run_parallel(2 * static_cast<int>(blocks.size()), threads, [&](int i) {
      refine(lattice, bound, lattice.root(2 * blocks[static_cast<std::size_t>(i / 2)] + i % 2));
    });
}

double largest_error(const Lattice& lattice, const TriangleBound& bound, int threads) {
  std::vector<double> errors(static_cast<std::size_t>(lattice.root_count()));
  run_parallel(lattice.root_count(), threads, [&](int root) {
    lattice.for_each_leaf(lattice.root(root), [&](const LatticeTriangle& t) {
      if (t.is_unit()) return;
      double& error = errors[static_cast<std::size_t>(root)];
      error = std::max(error, bound.largest_error(grid_triangle(lattice, t)));
    });
  });
  return *std::max_element(errors.begin(), errors.end());
}

/// Turns the leaves of the lattice into triangles of the dense sphere, by out(a, b, c).
template <class Out>
class LeafWriter {
 public:
  LeafWriter(const DenseSphere& sphere, const Lattice& lattice, Out& out)
      : sphere_(sphere), lattice_(lattice), out_(out) {}

  void operator()(const LatticeTriangle& t) const {
    if (t.is_unit())
      write_unit(t);
    else if (sphere_.valid(vertex(t.apex)))  // else it lies in a hole as a whole
      out_(vertex(t.apex), vertex(t.left), vertex(t.right));
    write_fan(t.apex, t.left);
    write_fan(t.left, t.right);
    write_fan(t.right, t.apex);
  }

 private:
  [[nodiscard]] GridVertex vertex(const LatticePoint& p) const {
    GridVertex v = lattice_.grid_vertex(p);
    if (v.column == sphere_.width) v.column = 0;
    return v;
  }

  void write_if_valid(const GridVertex& a, const GridVertex& b, const GridVertex& c) const {
    if (sphere_.valid(a) && sphere_.valid(b) && sphere_.valid(c)) out_(a, b, c);
  }

  /// Half a cell. When the other half is a leaf too, the cell is parted as in the full mesh, whatever the
  /// lattice's diagonal.
  void write_unit(const LatticeTriangle& t) const {
    const LatticePoint other{t.left.x + t.right.x - t.apex.x, t.left.y + t.right.y - t.apex.y};
    const GridVertex apex = lattice_.grid_vertex(t.apex), opposite = lattice_.grid_vertex(other);
    if (apex.row == opposite.row || apex.column == opposite.column) return;  // a repeated row or column
    if (!lattice_.is_split_at(other)) {
      write_if_valid(vertex(t.apex), vertex(t.left), vertex(t.right));
      return;
    }
    const auto [left, right] = std::minmax(t.apex.x, other.x);
    const auto [top, bottom] = std::minmax(t.apex.y, other.y);
    const GridVertex nw = vertex({left, top}), se = vertex({right, bottom});
    if (t.apex.x == left)
      write_if_valid(nw, vertex({left, bottom}), se);
    else
      write_if_valid(nw, se, vertex({right, top}));
  }

  /// Edges on the first and the last row are joined to the pole.
  void write_fan(const LatticePoint& a, const LatticePoint& b) const {
    if (a.y != b.y || (a.y != 0 && a.y != lattice_.height())) return;
    const GridVertex from = vertex(a), to = vertex(b);
    if (from.column != to.column) write_if_valid({a.y == 0 ? -1 : sphere_.height, 0}, to, from);
  }

  const DenseSphere& sphere_;
  const Lattice& lattice_;
  Out& out_;
};

}  // namespace

DepthMesh build_adaptive_mesh(const DenseSphere& sphere, double tolerance, int threads) {
  Lattice lattice(sphere.width, sphere.height);
  const TriangleBound bound(sphere, tolerance);
  refine_all(lattice, bound, threads);
  DepthMesh mesh = assemble_mesh(sphere, lattice.root_count(), threads, [&](int root, auto out) {
    lattice.for_each_leaf(lattice.root(root), LeafWriter(sphere, lattice, out));
  });
  mesh.max_relative_error = largest_error(lattice, bound, threads);
  return mesh;
}

}  // namespace seamline::renderer
