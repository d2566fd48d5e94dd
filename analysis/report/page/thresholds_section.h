#pragma once
#include <string>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// The thresholds of record with the paper's way, the paper's and the planted values beside them; Table 1 by
/// the paper's way where there is no joint model.
[[nodiscard]] std::string threshold_table_html(const Analysis& analysis);

/// What the thresholds do not speak of: other objects and scenes; how those of an artifact are averaged.
[[nodiscard]] std::string fixed_effects_text(const Analysis& analysis);

}  // namespace seamline::analysis
