#pragma once
#include <string>

#include "analysis/log_analysis/analysis.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// `deviations`: a row for each thing that is not as it was frozen. Call it only where something was frozen.
[[nodiscard]] CsvTable deviations_table(const FrozenComparison& frozen);

/// The verdict and the same for a terminal; empty where nothing was frozen.
[[nodiscard]] std::string frozen_text(const Analysis& analysis);

}  // namespace seamline::analysis
