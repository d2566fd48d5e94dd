#pragma once
#include "analysis/log_analysis/report_numbers.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// order.csv: noticeability by parts of the session, and its trend.
[[nodiscard]] CsvTable order_table(const Analysis& analysis, const ReportNumbers& numbers);

/// residuals.csv: how far each participant and each object lies from the others.
[[nodiscard]] CsvTable residuals_table(const ReportNumbers& numbers);

}  // namespace seamline::analysis
