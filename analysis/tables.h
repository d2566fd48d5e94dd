#pragma once
#include <vector>

#include "analysis/analysis.h"
#include "stimuli/support/csv.h"

namespace seamline {

/// Every number of the report as tables: cells, curves, thresholds, participants and answers.
[[nodiscard]] std::vector<CsvTable> report_tables(const Analysis& analysis);

}  // namespace seamline
