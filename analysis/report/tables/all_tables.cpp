#include "analysis/report/tables/all_tables.h"

#include "analysis/report/tables/preregistration_table.h"
#include "analysis/report/tables/table_columns.h"
#include "study/exchange/slider_records.h"
#include "study/running/staircase_results.h"

namespace seamline::analysis {
namespace {

/// Of the ordinal mixed model of the ratings.
CsvTable coefficients_table(const ReportNumbers& numbers) {
  CsvTable table{
      .name = "comparisons_coefficients",
      .columns = {{"coefficient", "text", "cut between two scores, effect, or participants' SD"},
                  {"estimate", "log odds", "logit units; effects: positive is noticed more"},
                  {"standard_error", "log odds", "over participants, by leaving out each in turn"},
                  {"ci95_low", "log odds", "lower end of the 95 % interval of this coefficient alone"},
                  {"ci95_high", "log odds", "upper end of it"},
                  {"p", "0 to 1", "two-sided, of this coefficient alone; empty where 0 means nothing"}},
      .rows = {}};
  if (!numbers.comparisons) return table;
  for (const CoefficientRow& row : numbers.comparisons->coefficients)
    table.rows.push_back({row.name, finite(row.estimate), finite(row.standard_error), finite(row.ci95_low),
                          finite(row.ci95_high), finite(row.p)});
  return table;
}

CsvTable contrasts_table(const ReportNumbers& numbers) {
  CsvTable table{
      .name = "comparisons_contrasts",
      .columns = {{"question", "text", "the question that the contrasts answer together"},
                  {"contrast", "text", "the difference of interest"},
                  {"estimate", "log odds", "logit units; positive is noticed more"},
                  {"standard_error", "log odds", "over participants, by leaving out each in turn"},
                  {"ci95_low", "log odds",
                   "lower end of the 95 % interval, simultaneous over the contrasts of the question"},
                  {"ci95_high", "log odds", "upper end of it"},
                  {"p", "0 to 1", "two-sided, of this contrast alone"},
                  {"adjusted_p", "0 to 1", "adjusted for all contrasts of the question"},
                  {"verdict", "word", "differs (adjusted p under 0.05), not shown or not estimable"},
                  {"conclusion", "text", "the same as a sentence"},
                  {"joint_p", "0 to 1",
                   "of all contrasts of the question together (Wald, Hotelling's degrees of freedom); empty "
                   "when there are too few participants"}},
      .rows = {}};
  if (!numbers.comparisons) return table;
  for (const ContrastTable& contrasts : numbers.comparisons->contrasts)
    for (const ContrastRow& row : contrasts.rows)
      table.rows.push_back({contrasts.question, row.name, finite(row.estimate), finite(row.standard_error),
                            finite(row.ci95_low), finite(row.ci95_high), finite(row.p),
                            finite(row.adjusted_p), std::string(word(row.verdict)), row.conclusion,
                            contrasts.joint_p ? finite(*contrasts.joint_p) : CsvValue(std::monostate{})});
  return table;
}

}  // namespace

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
