#pragma once
#include <vector>

#include "analysis/log_analysis/report_numbers.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// `thresholds_over_scenes.csv` and `thresholds_scenes.csv`; none where no artifact was shown in
/// `fewest_scenes` scenes.
[[nodiscard]] std::vector<CsvTable> scenes_tables(const Analysis& analysis, const ReportNumbers& numbers);

}  // namespace seamline::analysis
