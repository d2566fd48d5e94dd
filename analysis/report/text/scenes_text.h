#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/report_numbers.h"

namespace seamline::analysis {

/// Titles and cells of the table of thresholds over scenes, for terminal and page alike; no lines where no
/// artifact was shown in `fewest_scenes` scenes.
[[nodiscard]] std::vector<std::string> scenes_titles(const LevelAxis& axis);
[[nodiscard]] std::vector<std::vector<std::string>> scenes_lines(const ReportNumbers& numbers);

/// How people and scenes differ, and what may be claimed, a sentence each.
[[nodiscard]] std::vector<std::string> scenes_sentences(const ReportNumbers& numbers);

/// How it was computed, for a paper; empty where there are no such scenes.
[[nodiscard]] std::string scenes_method(const ReportNumbers& numbers);

/// For a terminal; empty where there are no such scenes.
[[nodiscard]] std::string scenes_text(const ReportNumbers& numbers);

}  // namespace seamline::analysis
