#include "renderer/set/set_work.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "renderer/set/set_layers.h"
#include "support/text/error.h"

namespace seamline::renderer {

bool SetWork::is_pending(const std::string& scene) const {
  return std::any_of(pending.begin(), pending.end(),
                     [&](const PendingStimulus& work) { return work.stimulus.scene == scene; });
}

SetWork find_work(const StudyDefinition& study, const RenderRequest& request, const InputHashes& hashes,
                  const SetRecords& records) {
  SetWork work;
  std::map<std::string, int> objects;  // in study order, for sharing out
  for (const Stimulus& stimulus : list_stimuli(study)) {
    if (!matches_pattern(stimulus_id(stimulus), request.only)) continue;
    work.selected_scenes.insert(stimulus.scene);
    const auto [object, added] =
        objects.emplace(stimulus.scene + "/" + stimulus.object, static_cast<int>(objects.size()));
    if (object->second % request.shard_count != request.shard - 1) continue;
    const std::string inputs = hashes.of_stimulus(stimulus);
    if (records.finished(stimulus_id(stimulus), inputs) &&
        !(request.layers && !has_layers(request.set_folder, stimulus, inputs)))
      ++work.already_finished;
    else
      work.pending.push_back({stimulus, inputs});
  }
  if (work.selected_scenes.empty())
    throw input_error({.file = study.file.string(),
                       .field = "--only",
                       .wanted = "a pattern that matches a stimulus id",
                       .found = "\"" + request.only + "\""});
  return work;
}

WorkWeights work_weights(Estimator estimator) {
  switch (estimator) {
    case Estimator::fast:
      return {.reference = 20, .truth = 0.3, .mesh = 0.5, .stimulus = 1};
    case Estimator::path:
      return {.reference = 1, .truth = 1.5, .mesh = 0.2, .stimulus = 2};
  }
  return {};
}

double total_weight(const SetWork& work, const WorkWeights& weights) {
  std::set<std::string> scenes, objects, widths;
  for (const PendingStimulus& pending : work.pending) {
    const Stimulus& stimulus = pending.stimulus;
    scenes.insert(stimulus.scene);
    objects.insert(stimulus.scene + stimulus.object);
    widths.insert(fmt::format("{}{}{}", stimulus.scene, stimulus.object, stimulus.condition.depth_width_px));
  }
  return static_cast<double>(scenes.size()) * weights.reference +
         static_cast<double>(objects.size()) * weights.truth +
         static_cast<double>(widths.size()) * weights.mesh +
         static_cast<double>(work.pending.size()) * weights.stimulus;
}

}  // namespace seamline::renderer
