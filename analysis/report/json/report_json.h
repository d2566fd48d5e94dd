#pragma once
#include <string>
#include <vector>

#include "analysis/report/page/methods_text.h"
#include "support/text/csv.h"

namespace seamline::analysis {

inline constexpr const char* report_format = "seamline report";
inline constexpr int report_version = 1;

/// The text of `REPORT/report.json`: format, version, study, source, notes, methods, and under `tables` the
/// rows of every CSV table as objects, so that a field means what the data dictionary says of the column of
/// the same name. Empty cells and NaN are null.
[[nodiscard]] std::string report_json(const Analysis& analysis, const MethodsText& methods,
                                      const std::vector<CsvTable>& tables);

}  // namespace seamline::analysis
