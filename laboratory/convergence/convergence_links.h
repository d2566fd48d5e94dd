#pragma once
#include <string>
#include <vector>

#include "laboratory/convergence/convergence_subject.h"

namespace seamline::renderer {

/// What one way of capturing depth costs, and how far the stimulus is then from the reference.
struct LinkRow {
  std::string link;     ///< that varies: source, noise, repair, ...
  std::string variant;  ///< "none" where the link is not there
  double rmse = 0;      ///< against the reference, display units; same sample points, so without their noise
  double scene_seconds = 0;     ///< from the truth to the local scene, ready for rays
  double stimulus_seconds = 0;  ///< stimulus pass and compositing
  std::int64_t triangles = 0;
};

/// The subject's stimulus with each link of the chain *source -> repair -> registration -> local scene* on
/// and off, and each way to decide who is in front; all else as it is. Sensors are the preset `tof_640x576`
/// at half its pixels, with its range opened; registered ones stand 6 cm beside the photograph's camera;
/// panoramas have the stimulus' own width. Seconds are medians of three runs, taken in turn. `truth` is the
/// subject's with its `spp` and the study's seed.
[[nodiscard]] std::vector<LinkRow> measure_links(const ConvergenceSubject& subject, const TruthSums& truth);

}  // namespace seamline::renderer
