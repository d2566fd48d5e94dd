#pragma once
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// The numbers of Figures 6 and 7 and of Table 1 as tables: cells, curves, thresholds and answers.
[[nodiscard]] std::vector<CsvTable> noticeability_tables(const Analysis& analysis);

}  // namespace seamline::analysis
