#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// How levels were placed (function, grid, prior, stopping rule) and what the group's thresholds are:
/// paragraphs for a paper, of an adaptive log.
[[nodiscard]] std::vector<std::string> adaptive_methods(const Analysis& analysis);

}  // namespace seamline::analysis
