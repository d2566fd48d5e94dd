#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/report/figures/figures.h"
#include "analysis/report/figures/stimulus_samples.h"

namespace seamline::analysis {

/// The whole report as one page that opens offline: figures and sample stimuli are inside. All text from
/// files and people is escaped. Light and dark by the reader's preference, and a style for print.
[[nodiscard]] std::string report_html(const Analysis& analysis, const ReportNumbers& numbers,
                                      const std::vector<Figure>& figures, const StimulusSamples& samples);

/// The page's style sheet.
[[nodiscard]] const char* report_style();

/// Table 1 from the data, beside the paper's and the planted values.
[[nodiscard]] std::string threshold_table_html(const Analysis& analysis);

/// What thresholds differ by between conditions; empty where the study has one.
[[nodiscard]] std::string differences_html(const Analysis& analysis);

/// The thresholds otherwise estimated, corrected for guessing, and with and without those whom a screen
/// names.
[[nodiscard]] std::string checks_html(const Analysis& analysis, const std::vector<Figure>& figures);

/// Functions of right choices with figure, table, warnings; the tracks of adaptive logs.
[[nodiscard]] std::string psychometric_html(const ReportNumbers& numbers, const std::vector<Figure>& figures);

/// The ordinal model's contrasts, a table a question, and its coefficients.
[[nodiscard]] std::string comparisons_html(const ReportNumbers& numbers);

[[nodiscard]] std::string times_html(const ReportNumbers& numbers, const std::vector<Figure>& figures);

[[nodiscard]] std::string participant_table_html(const ReportNumbers& numbers);

[[nodiscard]] std::string samples_html(const StimulusSamples& samples, const LevelAxis& axis = {});

}  // namespace seamline::analysis
