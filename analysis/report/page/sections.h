#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/log_analysis/report_numbers.h"
#include "analysis/report/figures/figures.h"
#include "analysis/report/figures/stimulus_samples.h"

namespace seamline::analysis {

// Sections of report.html, in the order of the page.

/// Sample stimuli as pictures inside the page, or the sentence that says why there are none.
[[nodiscard]] std::string samples_html(const StimulusSamples& samples, const LevelAxis& axis = {});

/// The thresholds of record with the paper's way, the paper's and the planted values beside them; Table 1 by
/// the paper's way where there is no joint model.
[[nodiscard]] std::string threshold_table_html(const Analysis& analysis);

/// Thresholds over scenes; empty where no artifact was shown in `fewest_scenes` scenes.
[[nodiscard]] std::string scenes_html(const ReportNumbers& numbers);

/// What the thresholds do not speak of: other objects and scenes; how those of an artifact are averaged.
[[nodiscard]] std::string fixed_effects_text(const Analysis& analysis);

/// How well the joint model describes the answers: scores observed and expected, p of choices and of ratings,
/// what is shared, how people differ.
[[nodiscard]] std::string joint_model_html(const Analysis& analysis, const std::vector<Figure>& figures);

/// A table of findings: each contrast's sentence, its estimate in `unit`, its interval.
[[nodiscard]] std::string contrast_table_html(const ContrastTable& contrasts, const std::string& unit);

/// Differences of thresholds and slopes by the joint model, between artifacts, conditions and groups.
[[nodiscard]] std::string joint_contrasts_html(const Analysis& analysis, const ReportNumbers& numbers);

/// Differences of thresholds and slopes by the joint model; folded, what the ordinal model says.
[[nodiscard]] std::string comparisons_html(const Analysis& analysis, const ReportNumbers& numbers);

/// Functions of right choices with figure, table, warnings; the tracks of adaptive logs.
[[nodiscard]] std::string psychometric_html(const Analysis& analysis, const ReportNumbers& numbers,
                                            const std::vector<Figure>& figures);

/// The thresholds otherwise estimated, corrected for guessing, and with and without those whom a screen
/// names.
[[nodiscard]] std::string checks_html(const Analysis& analysis, const std::vector<Figure>& figures);

/// The section "Lab and web"; nothing where all came by one way.
[[nodiscard]] std::string origins_html(const Analysis& analysis);

/// Response times: figure and table.
[[nodiscard]] std::string times_html(const ReportNumbers& numbers, const std::vector<Figure>& figures);

/// A line a participant of the log.
[[nodiscard]] std::string participant_table_html(const Analysis& analysis, const ReportNumbers& numbers);

/// Whether answers change during the session, and which participants and objects lie apart.
[[nodiscard]] std::string order_html(const ReportNumbers& numbers, const std::vector<Figure>& figures);

/// What deviates from what was frozen; empty where nothing was.
[[nodiscard]] std::string preregistration_html(const Analysis& analysis);

}  // namespace seamline::analysis
