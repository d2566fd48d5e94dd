#pragma once
#include <vector>

#include "analysis/log_analysis/report_numbers.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// What the joint model says: thresholds_joint, thresholds_people, joint_cells (observed and expected),
/// joint_contrasts, joint_checks, joint_parameters. Without rows where there is no joint model.
[[nodiscard]] std::vector<CsvTable> joint_tables(const Analysis& analysis, const ReportNumbers& numbers);

}  // namespace seamline::analysis
