#pragma once
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/log_analysis/report_numbers.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// Every table of the report, in the order of the page. `name` + ".csv" is a file each. A table without rows
/// is there all the same, so that readers find its columns.
[[nodiscard]] std::vector<CsvTable> all_tables(const Analysis& analysis, const ReportNumbers& numbers);

// What `all_tables` puts together.

/// The numbers of Figures 6 and 7 and of Table 1 as tables: cells, curves, thresholds and answers.
[[nodiscard]] std::vector<CsvTable> noticeability_tables(const Analysis& analysis);

/// What the joint model says: thresholds_joint, thresholds_people, joint_cells (observed and expected),
/// joint_contrasts, joint_checks, joint_parameters. Without rows where there is no joint model.
[[nodiscard]] std::vector<CsvTable> joint_tables(const Analysis& analysis, const ReportNumbers& numbers);

/// What stands beside the thresholds, as CSV tables with their data dictionary: `thresholds_beside`
/// (logistic, corrected for guessing, one object left out, per degree and field of view), `curves_corrected`,
/// `guessers`, `screening`, `thresholds_screened` and `opinion_scores`.
[[nodiscard]] std::vector<CsvTable> checks_tables(const Analysis& analysis);

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

/// response_times.csv: a line an artifact, width and kind of answer.
[[nodiscard]] CsvTable response_times_table(const ReportNumbers& numbers);

/// participants.csv: a line a participant of the log.
[[nodiscard]] CsvTable participants_table(const ReportNumbers& numbers);

/// tracks.csv: a line a participant and track of an adaptive log.
[[nodiscard]] CsvTable tracks_table(const ReportNumbers& numbers);

/// staircases.csv: of a study with `procedure = "staircase"`, a row a staircase.
[[nodiscard]] CsvTable staircases_table(const Analysis& analysis, const ReportNumbers& numbers);

/// order.csv: noticeability by parts of the session, and its trend.
[[nodiscard]] CsvTable order_table(const Analysis& analysis, const ReportNumbers& numbers);

/// residuals.csv: how far each participant and each object lies from the others.
[[nodiscard]] CsvTable residuals_table(const ReportNumbers& numbers);

/// `published.csv` and `published_orders.csv`; none where nothing was compared.
[[nodiscard]] std::vector<CsvTable> replication_tables(const Analysis& analysis);

/// `thresholds_over_scenes.csv` and `thresholds_scenes.csv`; none where no artifact was shown in
/// `fewest_scenes` scenes.
[[nodiscard]] std::vector<CsvTable> scenes_tables(const Analysis& analysis, const ReportNumbers& numbers);

}  // namespace seamline::analysis
