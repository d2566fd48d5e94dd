#pragma once
#include <cstddef>

#include "scenes/shapes/mesh.h"

namespace seamline::scenes {

/// Fewer triangles for the same shape: edges collapse in order of their quadric error (Garland and Heckbert
/// 1997) until `triangles` are left. A closed manifold stays one, and no triangle turns over. Normals are
/// those of the kept vertices.
[[nodiscard]] TriangleMesh decimated(const TriangleMesh& mesh, std::size_t triangles);

}  // namespace seamline::scenes
