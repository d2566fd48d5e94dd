#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/report/figures/figures.h"
#include "analysis/report/figures/stimulus_samples.h"
#include "analysis/report/tables/late_tables.h"
#include "analysis/report/tables/looking_tables.h"

namespace seamline::analysis {

/// The whole report as one page that opens offline: figures and sample stimuli are inside. All text from
/// files and people is escaped. Light and dark by the reader's preference, and a style for print.
[[nodiscard]] std::string report_html(const Analysis& analysis, const ReportNumbers& numbers,
                                      const std::vector<Figure>& figures, const StimulusSamples& samples,
                                      const std::vector<LookingRow>& looking = {},
                                      const std::optional<LateReport>& late = {});

}  // namespace seamline::analysis
