#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "analysis/over_scenes/scene_thresholds.h"

namespace seamline::analysis {

/// `scenes` of thresholds.json: a curve an element.
[[nodiscard]] nlohmann::ordered_json scenes_json(const std::vector<CurveOverScenes>& curves,
                                                 const LevelAxis& axis, bool conditions);

}  // namespace seamline::analysis
