#pragma once
#include <string>
#include <vector>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// How well the joint model describes the answers: scores observed and expected, p of choices and of ratings,
/// what is shared, how people differ.
[[nodiscard]] std::string joint_model_html(const Analysis& analysis, const std::vector<Figure>& figures);

/// A table of findings: each contrast's sentence, its estimate in `unit`, its interval.
[[nodiscard]] std::string contrast_table_html(const ContrastTable& contrasts, const std::string& unit);

/// Differences of thresholds and slopes by the joint model, between artifacts, conditions and groups.
[[nodiscard]] std::string joint_contrasts_html(const Analysis& analysis, const ReportNumbers& numbers);

}  // namespace seamline::analysis
