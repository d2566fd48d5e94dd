#pragma once
#include "analysis/log_analysis/report_numbers.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// comparisons_coefficients.csv and comparisons_contrasts.csv: the ordinal mixed model of the ratings.
[[nodiscard]] CsvTable coefficients_table(const ReportNumbers& numbers);
[[nodiscard]] CsvTable contrasts_table(const ReportNumbers& numbers);

}  // namespace seamline::analysis
