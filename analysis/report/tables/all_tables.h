#pragma once
#include <vector>

#include "analysis/log_analysis/report_numbers.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// Every table of the report, in the order of the page. `name` + ".csv" is a file each. A table without rows
/// is there all the same, so that readers find its columns.
[[nodiscard]] std::vector<CsvTable> all_tables(const Analysis& analysis, const ReportNumbers& numbers);

}  // namespace seamline::analysis
