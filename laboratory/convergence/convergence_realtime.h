#pragma once
#include <string>
#include <vector>

#include "laboratory/convergence/convergence_subject.h"

namespace seamline::renderer {

/// What one method of real time costs a frame, and how far its picture is from the traced one.
struct RealtimeRow {
  std::string method;   ///< a line of the figure
  std::string setting;  ///< along it: pixels of a map, lights, bands
  double rmse = 0;  ///< against rays through the same local scene, at the same sample points, display units
  double prepare_seconds = 0;  ///< what it makes before the first pixel: maps, lights, normals
  double ask_seconds = 0;      ///< one sample of every pixel, camera rays and all its direct light
};

/// Every method of `[pipeline]` in its settings, on the subject's local scene, and rays beside them. The
/// depth mesh answers all questions but those of bounce light and mirrors, which no method answers. Seconds
/// are processor time over all threads, medians of three, taken in turn; a picture has the subject's samples.
[[nodiscard]] std::vector<RealtimeRow> measure_realtime(const ConvergenceSubject& subject,
                                                        const TruthSums& truth);

}  // namespace seamline::renderer
