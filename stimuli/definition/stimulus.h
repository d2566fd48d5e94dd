#pragma once
#include <string>
#include <vector>

#include "stimuli/definition/artifact.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::inline stimuli {

/// What is varied between stimuli of one scene, object and artifact.
struct Condition {
  int depth_width_px = 0;  ///< W of the depth map; its height is W / 2
  int yaw_texels = 0;  ///< phase of the sampling grid: the panorama is turned by this many of its own texels

  [[nodiscard]] int depth_height_px() const { return depth_width_px / 2; }
  bool operator==(const Condition&) const = default;
};

/// One image shown to people.
struct Stimulus {
  std::string scene;
  Artifact artifact = Artifact::none;
  std::string object;    ///< the virtual object's name
  int object_index = 0;  ///< 1 left, 2 middle, 3 right
  Condition condition;
};

/// `bedroom-receiver-statue-0512`; a non-zero yaw is appended as `-yaw3`.
[[nodiscard]] std::string stimulus_id(const Stimulus& stimulus);

/// Every stimulus of a study: scenes, artifacts, objects and widths in the order of the study file, widths
/// innermost.
[[nodiscard]] std::vector<Stimulus> list_stimuli(const StudyDefinition& study);

/// Whether an id matches a pattern in which `*` stands for any text; an empty pattern matches everything.
[[nodiscard]] bool matches_pattern(std::string_view id, std::string_view pattern);

}  // namespace seamline::inline stimuli
