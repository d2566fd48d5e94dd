#pragma once
#include <string>

#include "analysis/log_analysis/report_numbers.h"

namespace seamline::analysis {

/// The ordinal model's contrasts, a table a question, and its coefficients.
[[nodiscard]] std::string comparisons_html(const ReportNumbers& numbers);

}  // namespace seamline::analysis
