#pragma once
#include <string>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// What deviates from what was frozen; empty where nothing was.
[[nodiscard]] std::string preregistration_html(const Analysis& analysis);

}  // namespace seamline::analysis
