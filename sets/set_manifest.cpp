#include "sets/set_manifest.h"

#include <set>

#include "raytracer/scene/truth_scene.h"
#include "raytracer/tracing/ray_device.h"
#include "renderer/transport/light_facts.h"
#include "support/files/assets.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

/// The plan for the scenes that the set has.
RenderPlan plan_of(const std::set<std::string>& scenes, const SetState& set,
                   std::map<std::string, LightFacts>& lights) {
  std::map<std::string, LightFacts> of_set;
  for (const SceneDefinition& scene : list_truths(set.study)) {
    if (!scenes.contains(scene.truth)) continue;
    if (!lights.contains(scene.truth))
      lights.emplace(scene.truth,
                     light_facts(load_truth_scene(scene, set.study.width_px, set.study.height_px)));
    of_set.emplace(scene.truth, lights.at(scene.truth));
  }
  return render_plan(set.study, of_set, set.settings);
}

}  // namespace

Manifest set_manifest(const SetState& set, std::map<std::string, LightFacts>& lights) {
  Manifest out;
  out.study_name = set.study.name;
  out.study_hash = set.identity;
  out.program_version = program_version();
  out.instruction_set = RayDevice::instruction_set();
  out.width_px = set.study.width_px;
  out.height_px = set.study.height_px;
  std::set<std::string> scenes;
  for (const Stimulus& stimulus : list_stimuli(set.study))
    if (auto record = set.records.finished(stimulus_id(stimulus), set.hashes.of_stimulus(stimulus))) {
      record->stimulus.depth.chain = stimulus.depth.chain;  // which the record holds as a text only
      record->stimulus.depth.mitigation = stimulus.depth.mitigation;
      record->stimulus.depth.pipeline = stimulus.depth.pipeline;
      out.stimuli.push_back(*record);
      scenes.insert(stimulus.truth);
    }
  for (const SceneDefinition& scene : list_truths(set.study))
    if (const auto reference =
            set.records.finished_reference(scene.truth, set.hashes.of_reference(scene.truth));
        reference && scenes.contains(scene.truth))
      out.references.push_back(*reference);
  out.left_out = sentences(plan_of(scenes, set, lights));
  return out;
}

bool is_begun_set(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::exists(folder / "manifest.json", error) ||
         std::filesystem::directory_iterator(folder / "records", error) !=
             std::filesystem::directory_iterator();
}

void require_set_folder(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::exists(folder, error) || is_begun_set(folder)) return;
  const bool is_folder = std::filesystem::is_directory(folder, error);
  bool has_others = !is_folder;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const bool is_hidden = entry.path().filename().string().starts_with(".");  // a probe, a mount's own
    const bool is_empty_folder = entry.is_directory(error) && std::filesystem::is_empty(entry, error);
    has_others = has_others || !(is_hidden || is_empty_folder);
  }
  if (has_others)
    throw input_error({.file = folder.string(),
                       .field = request_name("out"),
                       .wanted = "a new or an empty folder, or one with a set",
                       .found = is_folder ? "a folder with other things in it" : "a file"});
}

std::size_t stimuli_listed(const std::filesystem::path& set_folder, const StudyDefinition& study) {
  if (!std::filesystem::exists(set_folder / "manifest.json")) return 0;
  const Manifest existing = read_manifest(set_folder);
  if (existing.study_name != study.name)
    throw input_error({.file = set_folder.string(),
                       .wanted = "an empty folder or a set of study \"" + study.name + "\"",
                       .found = "a set of study \"" + existing.study_name + "\""});
  return existing.stimuli.size();
}

}  // namespace seamline::renderer
