#pragma once
#include "analysis/log_analysis/report_numbers.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// response_times.csv: a line an artifact, width and kind of answer.
[[nodiscard]] CsvTable response_times_table(const ReportNumbers& numbers);

/// participants.csv: a line a participant of the log.
[[nodiscard]] CsvTable participants_table(const ReportNumbers& numbers);

/// tracks.csv: a line a participant and track of an adaptive log.
[[nodiscard]] CsvTable tracks_table(const ReportNumbers& numbers);

/// staircases.csv: of a study with `procedure = "staircase"`, a row a staircase.
[[nodiscard]] CsvTable staircases_table(const Analysis& analysis, const ReportNumbers& numbers);

}  // namespace seamline::analysis
