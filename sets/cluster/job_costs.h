#pragma once
#include <cstdint>
#include <map>
#include <string>

#include "sets/render_set.h"

namespace seamline::renderer {

/// How long the pieces of a render take, in seconds of one process with the request's threads.
struct JobCosts {
  std::map<std::string, double> truths;   ///< reference and truth pass, by truth
  std::map<std::string, double> stimuli;  ///< by id
  std::map<std::string, double> meshes;  ///< depth map and mesh, by the id of the first stimulus that uses it
  double start = 0;                      ///< of every process: files read, trees built
  std::int64_t memory_bytes = 0;         ///< of one process, at most
  double measured_s = 0;                 ///< how long the probe took
  double share_probed = 0;               ///< of the render's work, as counted in advance
};

/// Renders samples of the study and scales them: of a truth, of its first object, each artifact and condition
/// at the first and the last level, with 2 samples a pixel, and with 8. The first truth's 2 samples are
/// always taken; further ones, and further truths, as long as all of them together are a fifth of the
/// render's work and took less than `budget_s` seconds. Time grows evenly with samples; levels between are
/// interpolated; truths that were not reached cost what those measured did on average. With an error to
/// reach, the samples that it takes are estimated from the error of the probe.
[[nodiscard]] JobCosts measure_costs(const StudyDefinition& study, const RenderRequest& request,
                                     double budget_s);

}  // namespace seamline::renderer
