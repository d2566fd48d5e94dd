#pragma once
#include <string>

#include "analysis/log_analysis/report_numbers.h"

namespace seamline::analysis {

/// The thresholds of record with the paper's way, the paper's and the planted values beside them; Table 1 by
/// the paper's way where there is no joint model.
[[nodiscard]] std::string threshold_table_html(const Analysis& analysis);

/// Thresholds over scenes; empty where no artifact was shown in `fewest_scenes` scenes.
[[nodiscard]] std::string scenes_html(const ReportNumbers& numbers);

/// What the thresholds do not speak of: other objects and scenes; how those of an artifact are averaged.
[[nodiscard]] std::string fixed_effects_text(const Analysis& analysis);

}  // namespace seamline::analysis
