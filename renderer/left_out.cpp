#include "renderer/left_out.h"

#include <fmt/core.h>

#include "renderer/answers.h"

namespace seamline {

std::vector<std::string> what_is_left_out(const StudyDefinition& study) {
  std::vector<std::string> sentences = {
      "textures: materials are diffuse base colours",
      "environment sampling: the environment is constant, so cosine-weighted rays sample it exactly"};
  for (const SceneDefinition& scene : study.scenes) {
    sentences.push_back(
        fmt::format("{}: {} of {} background renders, because all stimuli of an object share one", scene.name,
                    scene.objects.size() * (study.depth_width_px.size() * scene.artifacts.size() - 1),
                    scene.objects.size() * study.depth_width_px.size() * scene.artifacts.size()));
    if (scene.ambient_occlusion)
      sentences.push_back(
          fmt::format("{}: sun and bounce light, because its light is ambient occlusion", scene.name));
    for (const Artifact artifact : scene.artifacts) {
      const Answers answers = recipe(artifact, study.isolation).answers;
      if (answers.bounce == Who::truth)
        sentences.push_back(fmt::format(
            "{} {}: bounce light of the depth mesh, because the truth answers it, once for all widths",
            scene.name, word(artifact)));
    }
  }
  return sentences;
}

}  // namespace seamline
