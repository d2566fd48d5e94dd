#pragma once
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// `published.csv` and `published_orders.csv`; none where nothing was compared.
[[nodiscard]] std::vector<CsvTable> replication_tables(const Analysis& analysis);

}  // namespace seamline::analysis
