#pragma once
#include "analysis/report/numbers/report_numbers.h"
#include "support/text/csv.h"

namespace seamline::analysis {

// One table a function; `number_tables` lists them.

/// psychometric.csv: a line an artifact.
[[nodiscard]] CsvTable psychometric_table(const Analysis& analysis, const ReportNumbers& numbers);
/// psychometric_levels.csv: right choices at each width beside what the fit expects, and its residual.
[[nodiscard]] CsvTable psychometric_levels_table(const Analysis& analysis, const ReportNumbers& numbers);
/// psychometric_band.csv: the fitted curves with their bands, as drawn.
[[nodiscard]] CsvTable psychometric_band_table(const ReportNumbers& numbers);

/// comparisons_coefficients.csv and comparisons_contrasts.csv: the ordinal mixed model of the ratings.
[[nodiscard]] CsvTable coefficients_table(const ReportNumbers& numbers);
[[nodiscard]] CsvTable contrasts_table(const ReportNumbers& numbers);

/// response_times.csv: a line an artifact, width and kind of answer.
[[nodiscard]] CsvTable response_times_table(const ReportNumbers& numbers);

/// participants.csv: a line a participant of the log.
[[nodiscard]] CsvTable participants_table(const ReportNumbers& numbers);

/// tracks.csv: a line a participant and track of an adaptive log.
[[nodiscard]] CsvTable tracks_table(const ReportNumbers& numbers);

}  // namespace seamline::analysis
