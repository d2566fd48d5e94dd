#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "stimuli/set/manifest.h"

namespace seamline::inline stimuli {

/// How many pixels of its depth pictures a study's sensors deliver nothing for, before any repair, at one
/// level of a scene in a condition.
struct LevelHoles {
  std::string scene, condition;  ///< the condition's name, empty where the study has one
  Quantity quantity = Quantity::depth_width_px;
  double level = 0;
  std::int64_t holes = 0, pixels = 0;  ///< of all depth pictures together

  [[nodiscard]] double share() const { return static_cast<double>(holes) / static_cast<double>(pixels); }
};

/// Adds one depth picture; those of one scene, condition and level are counted together.
void add_holes(std::vector<LevelHoles>& holes, const Stimulus& stimulus, const SensorCounts& counts);

/// Of a set, in its order; empty where no sensor measured depth.
[[nodiscard]] std::vector<LevelHoles> holes_of_set(const Manifest& manifest);

/// A sentence for each scene and condition: the share of holes at each level; where the shares differ by more
/// than a hundredth of the picture, that a threshold over these levels is one of holes too.
[[nodiscard]] std::vector<std::string> sentences(const std::vector<LevelHoles>& holes);

/// What levels of a study change besides their quantity, known before anything is rendered; a sentence each.
[[nodiscard]] std::vector<std::string> notes_on_levels(const StudyDefinition& study);

}  // namespace seamline::inline stimuli
