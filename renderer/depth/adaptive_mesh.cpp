#include "renderer/depth/adaptive_mesh.h"

#include <algorithm>
#include <bit>

#include "renderer/depth/adaptive_mesh_assembly.h"
#include "renderer/depth/adaptive_mesh_bound.h"
#include "renderer/depth/lattice/refinement.h"

namespace seamline::renderer {
namespace {

/// Turns the leaves of the lattice into triangles of the dense sphere, by out(a, b, c).
template <class Out>
class LeafWriter {
 public:
  LeafWriter(const DenseSphere& sphere, const Lattice& lattice, Out& out)
      : sphere_(sphere), lattice_(lattice), out_(out) {}

  void operator()(const LatticeTriangle& t) const {
    if (t.is_unit())
      write_unit(
          lattice_, t, [this](const LatticePoint& p) { return vertex(p); },
          [this](const GridVertex& a, const GridVertex& b, const GridVertex& c) { write_if_valid(a, b, c); });
    else
      write_if_valid(vertex(t.apex), vertex(t.left), vertex(t.right));
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

/// A sixteenth of a turn is a triangle's largest leg: small enough that the curved edges of the sphere's
/// rows, which are straight in the mesh, never turn a triangle over, and large enough for any wall.
int sphere_block(int dense_width) {
  return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(16, dense_width) / 16)));
}

}  // namespace

Lattice sphere_lattice(const DenseSphere& sphere) {
  return Lattice(
      {.columns = sphere.width, .rows = sphere.height, .block = sphere_block(sphere.width), .wraps = true});
}

DepthMesh mesh_of_leaves(const DenseSphere& sphere, const Lattice& lattice, int threads) {
  return assemble_mesh(sphere, lattice.root_count(), threads, [&](int root, auto out) {
    lattice.for_each_leaf(lattice.root(root), LeafWriter(sphere, lattice, out));
  });
}

DepthMesh build_adaptive_mesh(const DenseSphere& sphere, double tolerance, int threads) {
  Lattice lattice = sphere_lattice(sphere);
  const TriangleBound bound(sphere, tolerance);
  refine_all(lattice, bound, threads);
  DepthMesh mesh = mesh_of_leaves(sphere, lattice, threads);
  mesh.max_relative_error = largest_error(lattice, bound, threads);
  return mesh;
}

}  // namespace seamline::renderer
