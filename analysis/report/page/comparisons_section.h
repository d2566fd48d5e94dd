#pragma once
#include <string>

#include "analysis/log_analysis/report_numbers.h"

namespace seamline::analysis {

/// Differences of thresholds and slopes by the joint model; folded, what the ordinal model says.
[[nodiscard]] std::string comparisons_html(const Analysis& analysis, const ReportNumbers& numbers);

}  // namespace seamline::analysis
