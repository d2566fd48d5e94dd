#pragma once
#include <string>
#include <vector>

#include "raytracer/scene/scene_measures.h"

namespace seamline::renderer {

/// One of the paper's rules for its scenes (sections 4.1.1 and 4.1.2), as found in one scene.
struct RuleResult {
  std::string scene;
  std::string rule;   ///< e.g. "distances equal within 5 %"
  std::string found;  ///< the numbers
  bool met = false;
};

/// Every rule that there is, in the order in which they are asked; documentation/reference/scene_rules.md
/// explains them.
[[nodiscard]] std::vector<std::string> scene_rules();

/// The rules that a scene's artifacts ask for. `receiver`: distances, areas, shadows on several surfaces.
/// `shadow` and `overlap`: distances, areas, bodies partly in shadow, shadows that cross. `occlusion`: equal
/// areas, partly hidden. All: rich silhouettes. Objects with `exempt_from_shape_rules` (the paper's teapot)
/// are left out of areas and silhouettes; a comparison of fewer than two objects is not asked. A rule about
/// what is not there (a shadow without a sun, an object outside the picture) is broken, in words.
[[nodiscard]] std::vector<RuleResult> check_scene(const TruthScene& scene);

}  // namespace seamline::renderer
