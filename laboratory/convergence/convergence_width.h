#pragma once
#include <vector>

#include "laboratory/convergence/convergence_subject.h"

namespace seamline::renderer {

/// What one width of the depth map costs, and how far the stimulus is from the reference.
struct WidthRow {
  int width_px = 0;
  double texels_per_pixel = 0;  ///< along the picture's middle row: under 1, a texel is wider than a pixel
  double rmse = 0;  ///< against the reference, display units; same sample points, so without their noise
  double capture_seconds = 0, mesh_seconds = 0, stimulus_seconds = 0;
  std::int64_t triangles = 0, rays = 0;  ///< rays of the stimulus pass
};

/// The stimulus at every width of the study. `truth` is the subject's with its `spp` and the study's seed.
[[nodiscard]] std::vector<WidthRow> measure_width(const ConvergenceSubject& subject, const TruthSums& truth);

}  // namespace seamline::renderer
