#pragma once
#include <cstdint>
#include <map>
#include <string>

#include "renderer/set/render_set.h"

namespace seamline::renderer {

/// How long the pieces of a render take, in seconds of one process with the request's threads.
struct JobCosts {
  std::map<std::string, double> truths;   ///< reference and truth pass, by truth
  std::map<std::string, double> stimuli;  ///< by id
  std::map<std::string, double> meshes;  ///< depth map and mesh, by the id of the first stimulus that uses it
  double start = 0;                      ///< of every process: files read, trees built
  std::int64_t memory_bytes = 0;         ///< of one process, at most
  double measured_s = 0;                 ///< how long the probe took
};

/// Renders samples of the study for about `budget_s` seconds (at least one truth, however long that takes)
/// and scales them: of every truth, of its first object, each artifact and condition at the first and the
/// last level, with 2 and with 8 samples a pixel. Time grows evenly with samples; levels between are
/// interpolated; truths that the budget did not reach cost what those measured did on average. With an error
/// to reach, the samples that it takes are estimated from the error of the probe.
[[nodiscard]] JobCosts measure_costs(const StudyDefinition& study, const RenderRequest& request,
                                     double budget_s);

}  // namespace seamline::renderer
