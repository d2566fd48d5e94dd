#pragma once
#include "laboratory/stability/common/namespaces.h"
#include "renderer/depth/dense_sphere.h"
#include "renderer/depth/depth_mesh.h"

namespace seamline::stability {

/// What rays from the centre through all vertices of a dense sphere find on a mesh, by brute force in double
/// precision, without the code that made the mesh.
struct MeshCheck {
  /// Largest |t - r| / r over every triangle that a ray touches, of which its vertex is no corner.
  double largest_error = 0;
  int rays_without_hit = 0;  ///< through valid vertices
  int holes_covered = 0;     ///< rays through holes that hit
  int facing_away = 0;       ///< triangles that do not face the centre
};
[[nodiscard]] MeshCheck check_mesh(const DepthMesh& mesh, const DenseSphere& sphere);

/// Where a ray from the centre meets the mesh, by brute force in double precision; infinity when it does not.
[[nodiscard]] double brute_force_distance_m(const DepthMesh& mesh, const Eigen::Vector3d& direction);

/// Directed edges of triangles that no other triangle has the other way round, and edges that are there
/// twice.
struct EdgeCheck {
  int open = 0;
  int repeated = 0;
};
[[nodiscard]] EdgeCheck check_edges(const DepthMesh& mesh);

}  // namespace seamline::stability
