#pragma once
#include <string>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// What thresholds differ by between conditions; empty where the study has one.
[[nodiscard]] std::string differences_html(const Analysis& analysis);

}  // namespace seamline::analysis
