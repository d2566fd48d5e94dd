#include "renderer/depth/full_mesh.h"

#include "renderer/depth/adaptive_mesh_assembly.h"

namespace seamline::renderer {

DepthMesh build_full_mesh(const DenseSphere& sphere, int threads) {
  // A part is the band between row `lower - 1` and row `lower`; the first and the last are the fans of the
  // poles.
  return assemble_mesh(sphere, sphere.height + 1, threads, [&](int lower, auto out) {
    const int upper = lower - 1;
    for (int left = 0; left < sphere.width; ++left) {
      const int right = left + 1 == sphere.width ? 0 : left + 1;
      const GridVertex nw{upper, left}, sw{lower, left}, se{lower, right}, ne{upper, right};
      if (!sphere.valid(nw) || !sphere.valid(se)) continue;  // both triangles of the cell need these
      if (lower < sphere.height && sphere.valid(sw)) out(nw, sw, se);
      if (upper >= 0 && sphere.valid(ne)) out(nw, se, ne);
    }
  });
}

}  // namespace seamline::renderer
