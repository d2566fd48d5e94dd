#pragma once
#include <string>
#include <vector>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// Response times: figure and table.
[[nodiscard]] std::string times_html(const ReportNumbers& numbers, const std::vector<Figure>& figures);

/// A line a participant of the log.
[[nodiscard]] std::string participant_table_html(const Analysis& analysis, const ReportNumbers& numbers);

}  // namespace seamline::analysis
