#include "analysis/report/tables/all_tables.h"

#include "analysis/report/tables/checks_tables.h"
#include "analysis/report/tables/comparisons_tables.h"
#include "analysis/report/tables/joint_tables.h"
#include "analysis/report/tables/noticeability_tables.h"
#include "analysis/report/tables/order_tables.h"
#include "analysis/report/tables/people_tables.h"
#include "analysis/report/tables/preregistration_table.h"
#include "analysis/report/tables/psychometric_tables.h"
#include "analysis/report/tables/replication_tables.h"
#include "analysis/report/tables/scenes_tables.h"
#include "study/exchange/slider_records.h"
#include "study/running/staircase_results.h"

namespace seamline::analysis {

std::vector<CsvTable> all_tables(const Analysis& analysis, const ReportNumbers& numbers) {
  std::vector<CsvTable> tables = noticeability_tables(analysis);
  for (CsvTable& table : std::vector<CsvTable>{
           psychometric_table(analysis, numbers), psychometric_levels_table(analysis, numbers),
           psychometric_band_table(numbers), coefficients_table(numbers), contrasts_table(numbers),
           order_table(analysis, numbers), residuals_table(numbers), response_times_table(numbers),
           participants_table(numbers), tracks_table(numbers)})
    tables.push_back(std::move(table));
  if (study::has_staircases(analysis.log)) tables.push_back(staircases_table(analysis, numbers));
  if (!numbers.detection.rows.empty()) tables.push_back(signal_detection_table(numbers));
  if (study::has_slider(analysis.log)) tables.push_back(slider_table(analysis, numbers));
  for (CsvTable& table : joint_tables(analysis, numbers)) tables.push_back(std::move(table));
  for (CsvTable& table : scenes_tables(analysis, numbers)) tables.push_back(std::move(table));
  for (CsvTable& table : checks_tables(analysis)) tables.push_back(std::move(table));
  for (CsvTable& table : replication_tables(analysis)) tables.push_back(std::move(table));
  if (analysis.frozen) tables.push_back(deviations_table(*analysis.frozen));
  return tables;
}

}  // namespace seamline::analysis
