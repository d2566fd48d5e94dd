#pragma once
#include "raytracer/light/light.h"
#include "renderer/picture/bounce_filter.h"
#include "renderer/picture/pixel_sums.h"
#include "renderer/picture/scene_sums.h"

namespace seamline::renderer {

/// How the truth of one object is taken from the sums of a scene.
struct TruthSumsOptions {
  FilterStrength filter = {};
  bool sky_apart =
      false;  ///< bounce light without the sky that is filtered with it, which is direct light then
  int threads = 1;
};

/// The truth of one object (from 1), taken from the sums of the truth pass, its bounce light filtered.
/// Scaled as if every tile had the most samples that one has.
[[nodiscard]] TruthSums truth_sums(const SceneSums& sums, const Camera& camera, const Light& light,
                                   int object, const TruthSumsOptions& options);

}  // namespace seamline::renderer
