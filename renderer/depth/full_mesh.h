#pragma once
#include "renderer/depth/dense_sphere.h"
#include "renderer/depth/depth_mesh.h"

namespace seamline::renderer {

/// Every cell of the dense sphere as two triangles, parted by the diagonal from its upper left to its lower
/// right corner as seen from the centre; each pole as a fan. The same diagonal everywhere: turning the map by
/// whole texels turns the mesh.
[[nodiscard]] DepthMesh build_full_mesh(const DenseSphere& sphere, int threads);

}  // namespace seamline::renderer
