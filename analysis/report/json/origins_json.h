#pragma once
#include <nlohmann/json.hpp>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// What stands under `origins`. Precondition: there is a comparison.
[[nodiscard]] nlohmann::ordered_json origins_json(const Analysis& analysis);

}  // namespace seamline::analysis
