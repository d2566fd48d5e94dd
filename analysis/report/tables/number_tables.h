#pragma once
#include <vector>

#include "analysis/report/numbers/report_numbers.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// `ReportNumbers` as tables: psychometric functions with levels and bands, comparisons, response times,
/// participants, tracks. A table without rows is there all the same, so that readers find its columns.
[[nodiscard]] std::vector<CsvTable> number_tables(const Analysis& analysis, const ReportNumbers& numbers);

}  // namespace seamline::analysis
