#pragma once
#include "analysis/log_analysis/report_numbers.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// psychometric.csv: a line an artifact.
[[nodiscard]] CsvTable psychometric_table(const Analysis& analysis, const ReportNumbers& numbers);
/// psychometric_levels.csv: right choices at each width beside what the fit expects, and its residual.
[[nodiscard]] CsvTable psychometric_levels_table(const Analysis& analysis, const ReportNumbers& numbers);
/// psychometric_band.csv: the fitted curves with their bands, as drawn.
[[nodiscard]] CsvTable psychometric_band_table(const ReportNumbers& numbers);

/// signal_detection.csv: d' and criterion at each level, of a task that asks for yes or no.
[[nodiscard]] CsvTable signal_detection_table(const ReportNumbers& numbers);

/// slider.csv: where the slider of a rating stood at each level.
[[nodiscard]] CsvTable slider_table(const Analysis& analysis, const ReportNumbers& numbers);

}  // namespace seamline::analysis
