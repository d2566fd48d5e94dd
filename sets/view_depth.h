#pragma once
#include "raytracer/scene/truth_scene.h"
#include "renderer/picture/composite.h"
#include "renderer/transport/answers.h"
#include "renderer/transport/scene_geometry.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// The depth beside a reference picture, planar metres: of everything that is there. Empty unless the scene's
/// view is a depth image.
[[nodiscard]] Image reference_depth(const TruthScene& scene);

/// The depth beside a stimulus, planar metres: of the virtual object, and of the real world as whoever says
/// what hides the object knows it (question 4), `mesh` or the truth. Empty unless the scene's view is a depth
/// image.
[[nodiscard]] Image stimulus_depth(const TruthScene& scene, const ObjectGeometry& truth, const Recipe& recipe,
                                   const Geometry* mesh);

/// Gives a composite the parallax of the depth mesh (renderer/views/depth_parallax.h), where the scene's view
/// says so. `truth` and `sums` are of the estimator that made it.
void give_depth_parallax(const TruthScene& scene, const TruthSums& truth, const Geometry* mesh,
                         const StimulusSums& sums, int threads, Composite& composite);

}  // namespace seamline::renderer
