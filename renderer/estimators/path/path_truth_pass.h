#pragma once
#include <functional>

#include "renderer/picture/pixel_sums.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/truth_scene.h"

namespace seamline::renderer {

/// How a pass over all pixels runs.
struct PassOptions {
  int spp = 64;
  std::uint64_t seed = 1;
  int threads = 1;
  std::function<void(double share_done)> progress = {};  ///< called on the calling thread
};

/// The truth of one virtual object: T (background and the two others) and the object alone.
struct ObjectGeometry {
  Geometry truth;
  Geometry object;
};
[[nodiscard]] ObjectGeometry object_geometry(const TruthScene& scene, int object_index);

/// Renders background and reference of one virtual object, and what they are summed from, as one coupled
/// computation.
[[nodiscard]] TruthSums render_truth(const TruthScene& scene, const ObjectGeometry& geometry,
                                     const PassOptions& options);

/// The reference of a whole scene, all objects in place, and its click map (0 background, 1 left, 2 middle, 3
/// right).
struct SceneReference {
  Image radiance;
  ByteImage object_ids;
  std::int64_t rays = 0;
};
[[nodiscard]] SceneReference render_reference(const TruthScene& scene, const PassOptions& options);

/// The click map alone.
[[nodiscard]] ByteImage click_map(const TruthScene& scene);

}  // namespace seamline::renderer
