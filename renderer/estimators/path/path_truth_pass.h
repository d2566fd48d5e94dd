#pragma once
#include "renderer/estimators/estimator.h"

namespace seamline::renderer {

/// Renders background and reference of one virtual object, and what they are summed from, as one coupled
/// computation.
[[nodiscard]] TruthSums render_truth(const TruthScene& scene, const ObjectGeometry& geometry,
                                     const PassOptions& options);

/// Renders the reference of a whole scene.
[[nodiscard]] SceneReference render_reference(const TruthScene& scene, const PassOptions& options);

}  // namespace seamline::renderer
