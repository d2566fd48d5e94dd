#pragma once
#include <string>

#include "analysis/log_analysis/report_numbers.h"

namespace seamline::analysis {

/// `ReportNumbers` for a terminal: psychometric functions, what the comparisons conclude, tracks, response
/// times; or why they are missing. Participants are counted elsewhere.
[[nodiscard]] std::string numbers_text(const Analysis& analysis, const ReportNumbers& numbers);

}  // namespace seamline::analysis
