#pragma once
#include <functional>
#include <vector>

#include "renderer/depth/occlusion_test.h"
#include "renderer/picture/scene_sums.h"
#include "renderer/transport/path_batch.h"
#include "renderer/transport/scene_geometry.h"

namespace seamline::renderer {

class SeenEmission;

/// How the fast estimator's truth pass runs: one for all objects of a scene.
struct ScenePassOptions {
  std::uint64_t seed = 1;
  int threads = 1;
  int tail_every = 4;
  FirstSky first_sky = FirstSky::direct;  ///< how a constant sky is kept; apart on the room's surfaces alone
  bool who_is_in_front = false;           ///< also keep what an occlusion asked of the depth mesh needs
  /// Decides whether the room hides an object, in place of distance; null: nobody does.
  const OcclusionTest* occlusion = nullptr;
  const SeenEmission* seen = nullptr;  ///< in place of what single samples see of small emitters
  std::function<void(double share_done)> progress = {};
};

/// Empty sums for a picture of the scene's camera.
[[nodiscard]] SceneSums empty_sums(const Camera& camera, std::size_t objects = 3);

/// Adds samples to every block until it has `wanted_spp[block]` (even numbers); blocks that have as many are
/// left alone. The background of each object, the reference, and each object's own light are one computation.
void add_samples(const TruthScene& scene, const SceneGeometry& geometry, const std::vector<int>& wanted_spp,
                 const ScenePassOptions& options, SceneSums& sums);

}  // namespace seamline::renderer
