#pragma once
#include "renderer/estimators/truth_pass.h"
#include "renderer/picture/error_estimate.h"
#include "renderer/picture/layers.h"
#include "renderer/picture/scene_sums.h"

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
