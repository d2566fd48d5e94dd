#pragma once
#include "renderer/picture/bounce_filter.h"
#include "renderer/picture/layers.h"
#include "renderer/picture/scene_sums.h"

namespace seamline::renderer {

/// How the sums of a scene become layers.
struct LayerOptions {
  FilterStrength filter = {};
  int threads = 1;
};

/// The truth layers of one object (1 to 3), taken from the sums of the joint pass, its bounce light filtered.
/// Scaled as if every tile had the most samples that one has.
[[nodiscard]] TruthLayers truth_layers(const SceneSums& sums, const Camera& camera,
                                       const Rgb& environment_radiance, int object,
                                       const LayerOptions& options);

}  // namespace seamline::renderer
