#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scenes/families/scene_family.h"

namespace seamline::laboratory {

/// A generated scene that keeps the rules of `check` (sets/check.h), and what it took.
struct KeptScene {
  scenes::GeneratedScene scene;  ///< as shown
  int scenes_drawn = 1;
  int placements_drawn = 0;
};

/// Scene number `number` (from 1) of a family and seed. Scenes are drawn, and in each their objects placed
/// anew, one at a time, as long as no more rules are broken than before; arcades' objects are scaled so that
/// equal areas are seen. The rules are asked at 480 x 270 and, in the end, at 960 x 540. Deterministic.
/// Throws InputError when 60 scenes did not do.
[[nodiscard]] KeptScene scene_that_keeps_rules(scenes::SceneFamily family, std::uint64_t seed, int number);

/// The name of a scene: "room_07".
[[nodiscard]] std::string scene_name(scenes::SceneFamily family, int number);

/// A study file of a family's scenes, each in NAME.glb beside it: the paper's widths, isolation and samples.
[[nodiscard]] std::string family_study_text(scenes::SceneFamily family,
                                            const std::vector<scenes::GeneratedScene>& scenes);

}  // namespace seamline::laboratory
