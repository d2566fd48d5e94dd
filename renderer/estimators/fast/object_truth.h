#pragma once
#include "raytracer/error/error_estimate.h"
#include "renderer/picture/pixel_sums.h"
#include "renderer/picture/scene_sums.h"
#include "renderer/transport/scene_geometry.h"

namespace seamline::renderer {

class SeenEmission;

/// What the fast estimator knows of one object before any stimulus with it.
struct ObjectTruth {
  const TruthScene& scene;
  const SceneSums& scene_sums;
  const ObjectGeometry& geometry;
  int object_index;
  const TruthSums& truth_sums;  ///< filtered
  const ErrorEstimate& error;   ///< of the truth's pictures
  /// Whether its sums are sorted by who is in front in the world of depth, which then agrees with the truth.
  bool sorted_by_depth = false;
  const SeenEmission* seen = nullptr;  ///< by which its sums were made
};

}  // namespace seamline::renderer
