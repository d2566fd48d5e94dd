#pragma once
#include <cstdint>

#include "renderer/depth/budget/shown_weights.h"
#include "renderer/depth/dense_sphere.h"
#include "renderer/depth/depth_mesh.h"

namespace seamline::renderer {

/// A mesh whose vertices are depth samples, and how many of them measured something.
struct BudgetedMesh {
  DepthMesh mesh;
  std::int64_t measured = 0, holes = 0;  ///< together the samples that were spent
};

/// The fewest samples that can be spent unevenly: more than the coarsest net has.
inline constexpr std::int64_t fewest_budgeted_samples = 512;

/// Spends samples on the vertices of a dense sphere: an eighth of them at most evenly, then one after the
/// other where a triangle is most wrong, as split by the adaptive mesh's network (adaptive_mesh.h). Exactly
/// `samples` are spent, or all vertices where there are no more; the poles' distances are means of samples.
///
/// How wrong a triangle is: the sum over the dense vertices under it of solid angle times g(|t - r| / r)
/// times the weight there, with g(e) = e^2 / (e^2 + e0^2); holes where there is something, and the contrary,
/// count
/// 1. Without weights e0 is 0.1, so that jumps of depth count. With weights e0 is 0.01, and a role's weight
/// is multiplied by what people see of it (`share_seen`) at the width that a uniform map of such triangles
/// has; a thousandth is added, so that what is left over is spent everywhere. One thread decides.
[[nodiscard]] BudgetedMesh build_budgeted_mesh(DenseSphere& sphere, std::int64_t samples,
                                               const ShownWeights* weights, double yaw_turns, int threads);

}  // namespace seamline::renderer
