#pragma once
#include "renderer/depth/occlusion_test.h"
#include "renderer/estimators/path/path_truth_pass.h"
#include "renderer/transport/answers.h"

namespace seamline::renderer {

/// Renders what one stimulus needs besides its truth: for each question the answering geometry is asked at
/// its own point. The mesh of `depth` may be null when the recipe asks nothing of it. `truth` must have been
/// rendered with the same samples per pixel and seed; where the depth mesh does not change which samples the
/// object covers, its sums are used instead of tracing again.
[[nodiscard]] StimulusSums render_stimulus(const TruthScene& scene, const ObjectGeometry& geometry,
                                           const DepthWorld& depth, const TruthSums& truth,
                                           const Recipe& recipe, const PassOptions& options);

}  // namespace seamline::renderer
