#include "analysis/analyze.h"

#include "analysis/analysis.h"
#include "analysis/checks_tables.h"
#include "analysis/checks_text.h"
#include "analysis/figures.h"
#include "analysis/report_html.h"
#include "analysis/stimulus_samples.h"
#include "analysis/tables.h"
#include "analysis/threshold_rows.h"
#include "analysis/thresholds_json.h"
#include "stimuli/support/atomic_file.h"
#include "stimuli/support/gnuplot.h"

namespace seamline {

AnalysisSummary analyze_log(const AnalysisRequest& request) {
  require_gnuplot();
  AnalysisOptions options;
  options.field_of_view_deg = request.field_of_view_deg;
  options.exclude_screened = request.exclude_screened;
  const Analysis analysis =
      analyze(read_log(request.log), request.include_pilot,
              {.replicates = request.bootstrap_replicates, .seed = request.seed, .threads = request.threads},
              options);

  const std::filesystem::path& folder = request.report_folder;
  const std::filesystem::path figures_folder = folder / "figures";
  prepare_output_folder(folder);
  prepare_output_folder(figures_folder);
  const std::vector<Figure> figures = draw_figures(analysis, figures_folder);
  const StimulusSamples samples = sample_stimuli(analysis, folder);
  std::vector<CsvTable> tables = report_tables(analysis);
  for (CsvTable& table : checks_tables(analysis)) tables.push_back(std::move(table));
  for (const CsvTable& table : tables) write_file_atomically(folder / (table.name + ".csv"), csv_text(table));
  write_file_atomically(folder / "data_dictionary.csv", csv_text(data_dictionary(tables)));
  write_file_atomically(folder / "thresholds.json", thresholds_json(analysis));
  write_file_atomically(folder / "report.html", report_html(analysis, figures, samples));
  return {.table = table_text(analysis),
          .checks = checks_text(analysis),
          .notes = analysis.notes,
          .report_html = folder / "report.html"};
}

}  // namespace seamline
