#include "stimuli/definition/stimulus.h"

#include <fmt/core.h>

namespace seamline::inline stimuli {

std::string stimulus_id(const Stimulus& stimulus) {
  const std::string id = fmt::format("{}-{}-{}-{:04}", stimulus.scene, word(stimulus.artifact),
                                     stimulus.object, stimulus.condition.depth_width_px);
  return stimulus.condition.yaw_texels == 0 ? id : fmt::format("{}-yaw{}", id, stimulus.condition.yaw_texels);
}

std::vector<Stimulus> list_stimuli(const StudyDefinition& study) {
  std::vector<Stimulus> stimuli;
  for (const SceneDefinition& scene : study.scenes)
    for (const Artifact artifact : scene.artifacts)
      for (std::size_t object = 0; object < scene.objects.size(); ++object)
        for (const int width_px : study.depth_width_px)
          stimuli.push_back({.scene = scene.name,
                             .artifact = artifact,
                             .object = scene.objects[object].name,
                             .object_index = static_cast<int>(object) + 1,
                             .condition = {.depth_width_px = width_px, .yaw_texels = study.yaw_texels}});
  return stimuli;
}

bool matches_pattern(std::string_view id, std::string_view pattern) {
  if (pattern.empty()) return true;
  std::size_t i = 0, p = 0, star = std::string_view::npos, resume = 0;
  while (i < id.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = i;
    } else if (p < pattern.size() && pattern[p] == id[i]) {
      ++p;
      ++i;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      i = ++resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace seamline::inline stimuli
