#pragma once
#include "renderer/estimators/path/path_depth_pass.h"

namespace seamline::renderer {

class SeenEmission;

// The passes of the path estimator with what small emitters in view send to the camera given; null: as single
// samples see it.

[[nodiscard]] TruthSums render_truth(const TruthScene& scene, const ObjectGeometry& geometry,
                                     const PassOptions& options, const SeenEmission* seen);

[[nodiscard]] SceneReference render_reference(const TruthScene& scene, const PassOptions& options,
                                              const SeenEmission* seen);

/// `truth`: made with the same.
[[nodiscard]] StimulusSums render_stimulus(const TruthScene& scene, const ObjectGeometry& geometry,
                                           const DepthWorld& depth, const TruthSums& truth,
                                           const Recipe& recipe, const PassOptions& options,
                                           const SeenEmission* seen);

}  // namespace seamline::renderer
