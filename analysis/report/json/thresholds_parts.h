#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/over_scenes/scene_thresholds.h"

namespace seamline::analysis {

// Parts of thresholds.json.

/// What stands beside the thresholds of one artifact: `logistic_thresholds`, `corrected_for_guessing`,
/// `one_object_left_out` and `field_of_view`.
[[nodiscard]] nlohmann::ordered_json artifact_checks_json(const Analysis& analysis, std::size_t index);

/// What stands beside all of them: `guessing`, `screening`, `thresholds_by_screen` and `sos_parameter`.
[[nodiscard]] nlohmann::ordered_json checks_json(const Analysis& analysis);

/// What stands under `origins`. Precondition: there is a comparison.
[[nodiscard]] nlohmann::ordered_json origins_json(const Analysis& analysis);

/// `scenes` of thresholds.json: a curve an element.
[[nodiscard]] nlohmann::ordered_json scenes_json(const std::vector<CurveOverScenes>& curves,
                                                 const LevelAxis& axis, bool conditions);

}  // namespace seamline::analysis
