#pragma once
#include <string>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// Published thresholds beside those of the study; empty where none were given.
[[nodiscard]] std::string replication_html(const Analysis& analysis);

}  // namespace seamline::analysis
