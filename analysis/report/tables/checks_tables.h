#pragma once
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// What stands beside the thresholds, as CSV tables with their data dictionary: `thresholds_beside`
/// (logistic, corrected for guessing, one object left out, per degree and field of view), `curves_corrected`,
/// `guessers`, `screening`, `thresholds_screened` and `opinion_scores`.
[[nodiscard]] std::vector<CsvTable> checks_tables(const Analysis& analysis);

}  // namespace seamline::analysis
