#pragma once
#include "renderer/error_estimate.h"
#include "renderer/layers.h"
#include "renderer/scene_sums.h"
#include "renderer/truth_pass.h"

namespace seamline::renderer {

/// What the fast estimator knows of one object before any stimulus with it.
struct ObjectTruth {
  const TruthScene& scene;
  const SceneSums& sums;
  const ObjectGeometry& geometry;
  int object_index;
  const TruthLayers& layers;   ///< filtered
  const ErrorEstimate& error;  ///< of the truth's pictures
};

}  // namespace seamline::renderer
