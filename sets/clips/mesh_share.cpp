#include "sets/clips/mesh_share.h"

#include <fmt/core.h>

#include <optional>

#include "stimuli/definition/clip_frames.h"
#include "support/files/hash.h"

namespace seamline::renderer {
namespace {

/// Whether the mesh follows from what is real and the settings alone: not from the photograph, nor from where
/// the inserted object is.
bool is_of_the_real_alone(const DepthSettings& depth) {
  if (depth.mitigation != Mitigation{} || depth.pipeline != Pipeline{} ||
      depth.albedo != MeshAlbedo::constant)
    return false;
  return !depth.chain ||
         (!guided_by_photograph(*depth.chain) && !is_budgeted(*depth.chain) && !has_stereo(*depth.chain));
}

std::string meaning_of(const DepthSettings& depth) {
  return fmt::format("{} {} {} {} {} {}", depth.width_px, depth.yaw_texels, static_cast<int>(depth.mesh),
                     depth.mesh_tolerance, depth.chain ? canonical_text(depth.chain) : std::string(),
                     depth.chain ? depth.chain->seed : 0);
}

/// What the depth map is of.
std::string meaning_of(SceneDefinition scene, int virtual_index) {
  scene.truth.clear();
  scene.objects.erase(scene.objects.begin() + virtual_index - 1);
  return canonical_text(scene);
}

}  // namespace

MeshShare::MeshShare(const StudyDefinition& frames, const std::vector<Stimulus>& rendered,
                     const std::function<bool(const Stimulus&)>& traces_rays) {
  if (!is_of_frames(frames)) return;
  std::map<std::string, SceneDefinition> truths;
  for (const SceneDefinition& truth : list_truths(frames)) truths.emplace(truth.truth, truth);
  for (const Stimulus& stimulus : rendered) {
    if (!is_of_the_real_alone(stimulus.depth)) continue;
    const std::optional<SceneDefinition> then = captured_scene(frames, stimulus);
    const SceneDefinition& seen = then ? *then : truths.at(truth_of(stimulus));
    const std::string key =
        sha256(fmt::format("{} {} {}\n{}", stimulus.object_index, traces_rays(stimulus),
                           meaning_of(stimulus.depth), meaning_of(seen, stimulus.object_index)));
    of_stimulus_[stimulus_id(stimulus)] = key;
    ++meshes_[key].to_come;
  }
}

std::shared_ptr<const LocalScene> MeshShare::find(const Stimulus& stimulus) const {
  const auto key = of_stimulus_.find(stimulus_id(stimulus));
  return key == of_stimulus_.end() ? nullptr : meshes_.at(key->second).made;
}

void MeshShare::finish(const Stimulus& stimulus, const std::shared_ptr<const LocalScene>& mesh) {
  const auto key = of_stimulus_.find(stimulus_id(stimulus));
  if (key == of_stimulus_.end()) return;
  Mesh& known = meshes_.at(key->second);
  --known.to_come;
  known.made = known.to_come > 0 ? mesh : nullptr;
}

}  // namespace seamline::renderer
