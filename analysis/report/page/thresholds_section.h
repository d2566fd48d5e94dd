#pragma once
#include <string>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// Table 1 from the data, beside the paper's and the planted values.
[[nodiscard]] std::string threshold_table_html(const Analysis& analysis);

}  // namespace seamline::analysis
