#include "sets/set_work.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "sets/set_layers.h"
#include "stimuli/definition/clip_frames.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::renderer {

bool SetWork::is_pending(const std::string& truth) const {
  const auto first = of_object.lower_bound({truth, 0});
  return first != of_object.end() && first->first.first == truth;
}

InputError no_such_stimulus(const StudyDefinition& study, const std::string& only) {
  return input_error({.file = study.file.string(),
                      .field = request_name("only"),
                      .wanted = "a pattern that matches a stimulus id",
                      .found = "\"" + only + "\""});
}

void require_nothing_pending(const SetWork& work, const std::filesystem::path& set_folder) {
  if (work.pending.empty()) return;
  throw input_error({.file = set_folder.string(),
                     .wanted = "a set whose stimuli are all rendered",
                     .found = fmt::format("{} that are not, the first being {}", work.pending.size(),
                                          stimulus_id(work.pending.front().stimulus))});
}

SetWork find_work(const StudyDefinition& study, const RenderRequest& request, const InputHashes& hashes,
                  const SetRecords& records) {
  SetWork work;
  std::map<std::string, int> objects;  // in study order, for sharing out
  for (const Stimulus& stimulus : list_stimuli(study)) {
    if (!matches_pattern(stimulus_id(stimulus), request.only)) continue;
    const bool is_asked = request.ids.empty() || request.ids.contains(stimulus_id(stimulus));
    if (is_asked) work.selected_truths.insert(truth_of(stimulus));
    const auto [object, added] =
        objects.emplace(truth_of(stimulus) + "/" + stimulus.object, static_cast<int>(objects.size()));
    if (object->second % request.shard_count != request.shard - 1) continue;
    if (!is_asked) continue;
    const std::string inputs = hashes.of_stimulus(stimulus);
    if (records.finished(stimulus_id(stimulus), inputs) &&
        !(request.layers && !has_layers(request.set_folder, stimulus, inputs))) {
      ++work.already_finished;
    } else {
      work.of_object[{truth_of(stimulus), stimulus.object_index}].push_back(work.pending.size());
      work.pending.push_back({stimulus, inputs});
    }
  }
  if (work.selected_truths.empty()) throw no_such_stimulus(study, request.only);
  return work;
}

WorkList list_work(const StudyDefinition& study, const std::string& only, const InputHashes& hashes,
                   const std::string& job) {
  WorkList list{.study = study.name, .job = job, .stimuli = {}, .references = {}};
  std::set<std::string> truths;
  for (const Stimulus& stimulus : list_stimuli(study))
    if (matches_pattern(stimulus_id(stimulus), only)) {
      list.stimuli.push_back({stimulus_id(stimulus), hashes.of_stimulus(stimulus), truth_of(stimulus)});
      truths.insert(truth_of(stimulus));
    }
  for (const SceneDefinition& scene : list_truths(study))
    if (truths.contains(scene.truth))
      list.references.push_back({scene.truth, hashes.of_reference(scene.truth)});
  return list;
}

StimuliOfTruths stimuli_of_truths(const StudyDefinition& study) {
  StimuliOfTruths stimuli;
  for (Stimulus& stimulus : list_stimuli(study)) {
    std::vector<Stimulus>& of_truth = stimuli[truth_of(stimulus)];
    of_truth.push_back(std::move(stimulus));
  }
  return stimuli;
}

Answers asked_of_depth(const std::vector<Stimulus>& of_truth) {
  std::set<std::pair<Artifact, Isolation>> asking;
  for (const Stimulus& stimulus : of_truth) asking.insert({stimulus.artifact, stimulus.isolation});
  std::vector<Recipe> recipes;
  for (const auto& [artifact, isolation] : asking) recipes.push_back(recipe(artifact, isolation));
  return asked_by_any(recipes);
}

std::vector<std::vector<PendingStimulus>> by_mesh(const SetWork& work, const StudyDefinition& study,
                                                  const std::string& truth, int object_index) {
  const auto of_object = work.of_object.find({truth, object_index});
  if (of_object == work.of_object.end()) return {};
  std::map<std::pair<std::string, DepthSettings>, std::vector<PendingStimulus>> alike;
  for (const std::size_t i : of_object->second) {
    const PendingStimulus& one = work.pending[i];
    const std::optional<SceneDefinition> captured = captured_scene(study, one.stimulus);
    alike[{captured ? canonical_text(*captured) : std::string(), one.stimulus.depth}].push_back(one);
  }
  std::vector<std::vector<PendingStimulus>> meshes;
  for (auto& [mesh, works] : alike) meshes.push_back(std::move(works));
  return meshes;
}

std::vector<std::vector<PendingStimulus>> by_picture(const std::vector<PendingStimulus>& works) {
  std::vector<std::vector<PendingStimulus>> alike;
  for (const PendingStimulus& work : works) {
    const auto found = std::find_if(alike.begin(), alike.end(), [&](const auto& others) {
      const Stimulus& other = others.front().stimulus;
      return other.artifact == work.stimulus.artifact && other.isolation == work.stimulus.isolation;
    });
    (found == alike.end() ? alike.emplace_back() : *found).push_back(work);
  }
  return alike;
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
  std::set<std::string> truths, objects;
  std::set<std::pair<std::string, DepthSettings>> meshes;
  for (const PendingStimulus& pending : work.pending) {
    const Stimulus& stimulus = pending.stimulus;
    truths.insert(truth_of(stimulus));
    objects.insert(truth_of(stimulus) + "/" + stimulus.object);
    meshes.insert({truth_of(stimulus) + "/" + stimulus.object, stimulus.depth});
  }
  return truths.size() * weights.reference + objects.size() * weights.truth + meshes.size() * weights.mesh +
         work.pending.size() * weights.stimulus;
}

RenderSettings render_settings(const StudyDefinition& study, const RenderRequest& request) {
  bool sets_mesh = study.level.quantity == Quantity::mesh_tolerance;
  for (const ConditionDefinition& condition : study.conditions)
    sets_mesh = sets_mesh || condition.depth.mesh != study.depth.mesh ||
                condition.depth.mesh_tolerance != study.depth.mesh_tolerance;
  if (request.mesh && sets_mesh)
    throw input_error({.field = request_name("mesh"),
                       .wanted = "a study whose conditions and levels leave the mesh to the command line",
                       .found = study.file.string() + ", which varies it"});
  return {.spp = request.spp.value_or(study.samples_per_pixel),
          .seed = study.seed,
          .mesh = request.mesh,
          .estimator = request.estimator,
          .error = request.error,
          .omit = request.omit};
}

}  // namespace seamline::renderer
