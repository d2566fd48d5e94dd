#pragma once
#include <vector>

#include "analysis/scores/level_axis.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// `data_dictionary.csv`: every column of every table (and so every field of the rows in `report.json`, which
/// bear the same names), the other fields of `report.json`, and every field of `thresholds.json`. Fields are
/// paths, "artifacts[].cells[].mean"; [] is every element of a list.
[[nodiscard]] CsvTable report_dictionary(const std::vector<CsvTable>& tables, const LevelAxis& axis = {},
                                         bool conditions = false);

}  // namespace seamline::analysis
