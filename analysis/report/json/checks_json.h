#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// What stands beside the thresholds of one artifact: `logistic_thresholds`, `corrected_for_guessing`,
/// `one_object_left_out` and `field_of_view`.
[[nodiscard]] nlohmann::ordered_json artifact_checks_json(const Analysis& analysis, std::size_t index);

/// What stands beside all of them: `guessing`, `screening`, `thresholds_by_screen` and `sos_parameter`.
[[nodiscard]] nlohmann::ordered_json checks_json(const Analysis& analysis);

}  // namespace seamline::analysis
