#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/definition/artifact.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::inline stimuli {

/// One image shown to people.
struct Stimulus {
  std::string scene;
  Artifact artifact = Artifact::none;
  std::string object;                            ///< the virtual object's name
  int object_index = 0;                          ///< from the left, from 1
  std::string condition = {};                    ///< its name; empty where the study has one condition
  Quantity quantity = Quantity::depth_width_px;  ///< the study's: what the level is a value of
  double level = 0;
  DepthSettings depth = {};  ///< as condition and level make it
  Isolation isolation = Isolation::query;
  std::string truth = {};  ///< see `truth_of`
};

/// The scene with the light that a stimulus is compared in, as `list_truths` names it: the scene's own name
/// where nothing was said.
[[nodiscard]] inline const std::string& truth_of(const Stimulus& stimulus) {
  return stimulus.truth.empty() ? stimulus.scene : stimulus.truth;
}

[[nodiscard]] inline const std::string& truth_of(const SceneDefinition& scene) {
  return scene.truth.empty() ? scene.name : scene.truth;
}

/// `bedroom-receiver-statue-0512`; with the condition's name before the level where there is more than one
/// (`bedroom-receiver-statue-soft-0512`), and a yaw that is not 0 behind it as `-yaw3` or `-yaw0p25`.
[[nodiscard]] std::string stimulus_id(const Stimulus& stimulus);

/// Every stimulus of a study: scenes, artifacts, objects, conditions and levels in the order of the study
/// file, levels innermost.
[[nodiscard]] std::vector<Stimulus> list_stimuli(const StudyDefinition& study);

/// The scenes of a study, once for each light that its conditions and levels give them; stimuli name them by
/// `truth`. In the order of the study file. A study that varies only depth has each scene once.
[[nodiscard]] std::vector<SceneDefinition> list_truths(const StudyDefinition& study);

/// The widths of a study's depth maps, rising, each once.
[[nodiscard]] std::vector<int> depth_widths_px(const StudyDefinition& study);

/// Whether an id matches a pattern in which `*` stands for any text; an empty pattern matches everything.
[[nodiscard]] bool matches_pattern(std::string_view id, std::string_view pattern);

}  // namespace seamline::inline stimuli
