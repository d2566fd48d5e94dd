#pragma once
#include "scenes/shapes/field.h"
#include "scenes/shapes/mesh.h"

namespace seamline::scenes {

struct PolygoniseOptions {
  double cell_m =
      0.01;  ///< edge of a cube of the body-centred lattice; about 13 triangles per cell_m^2 of surface
  int threads = 2;            ///< the result does not depend on it
  std::size_t triangles = 0;  ///< the mesh is decimated to about this many; 0 keeps all
  double ground_m = 0.0;      ///< the sculpture is cut off flat below this height
};

/// The sculpture's surface as one closed manifold: marching tetrahedra on a body-centred cubic lattice (all
/// tetrahedra congruent and nearly regular), decimated, vertices moved onto the surface by Newton steps,
/// normals from the field's gradient; the largest piece is kept.
[[nodiscard]] TriangleMesh polygonise(const Sculpture& sculpture, const PolygoniseOptions& options);

}  // namespace seamline::scenes
