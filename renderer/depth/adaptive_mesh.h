#pragma once
#include "renderer/depth/dense_sphere.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/depth/lattice/lattice.h"

namespace seamline::renderer {

/// A right-triangulated irregular network over the dense sphere (in the manner of Evans, Kirkpatrick and
/// Townsend 2001), refined from coarse to fine until every triangle holds its bound: along the ray of each
/// dense vertex that the triangle can be hit by, its distance t and the vertex's distance r satisfy |t - r| /
/// r <= tolerance (see TriangleBound). No cracks: neighbours share their whole edges, across the seam and at
/// the poles too.
///
/// Where cells remain whole they are parted as in the full mesh, so that depth jumps and the borders of holes
/// are the full mesh's own. A tolerance under about 1e-7, the rounding of the vertices to float, ends at full
/// density.
[[nodiscard]] DepthMesh build_adaptive_mesh(const DenseSphere& sphere, double tolerance, int threads);

/// The lattice of such a mesh, not yet split.
[[nodiscard]] Lattice sphere_lattice(const DenseSphere& sphere);

/// The mesh of a lattice's leaves, which share their whole edges. Its error is not known.
[[nodiscard]] DepthMesh mesh_of_leaves(const DenseSphere& sphere, const Lattice& lattice, int threads);

}  // namespace seamline::renderer
