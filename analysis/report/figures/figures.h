#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/report_numbers.h"

namespace seamline::analysis {

/// A figure of the report.
struct Figure {
  std::string name;  ///< of the file, without `.svg`
  std::string title;
  std::string caption;
  std::filesystem::path svg;
};

/// Draws into `folder` the paper's Fig. 6 (a panel an artifact, a line an object, SEM bars) and Fig. 7
/// (averages over objects with dotted lines at 0.5 and 1.0; not of adaptive logs, which have no averages),
/// psychometric functions, curves corrected for guessing and response times, as far as there are such
/// numbers; with colours that colour-blind readers can tell apart (Okabe and Ito) and a shape a line.
[[nodiscard]] std::vector<Figure> draw_figures(const Analysis& analysis, const ReportNumbers& numbers,
                                               const std::filesystem::path& folder);

/// The SVG of a figure as part of a page: no XML header, ids that are unique on the page, and text and axes
/// in the page's own text colour, so that it suits a light and a dark page.
[[nodiscard]] std::string inline_svg(const Figure& figure);

// Each figure alone; none where there are no such numbers.

/// Mean noticeability as answered (points with standard errors) and by the joint model (line with 95 % band),
/// as counted and of what is seen. None where the model has no numbers.
[[nodiscard]] std::optional<Figure> joint_curves_figure(const Analysis& analysis,
                                                        const std::filesystem::path& folder);

/// Shares of every score at every level, observed (points) and expected by the joint model (lines).
[[nodiscard]] std::optional<Figure> joint_scores_figure(const Analysis& analysis,
                                                        const std::filesystem::path& folder);

/// Mean noticeability of every participant, a thin line each, under the mean over participants; a panel a
/// curve. None of adaptive logs, and of one participant.
[[nodiscard]] std::optional<Figure> people_figure(const Analysis& analysis,
                                                  const std::filesystem::path& folder);

/// Right choices against width: points by trials, fitted curve with its band, residuals below. None where
/// there are no such numbers.
[[nodiscard]] std::optional<Figure> psychometric_figure(const Analysis& analysis,
                                                        const ReportNumbers& numbers,
                                                        const std::filesystem::path& folder);

/// Mean noticeability as answered and corrected for guessing. None where there are no such numbers.
[[nodiscard]] std::optional<Figure> guessing_figure(const Analysis& analysis,
                                                    const std::filesystem::path& folder);

/// Median time to the choice against width, right and wrong choices apart, with quartiles. None where there
/// are no such numbers.
[[nodiscard]] std::optional<Figure> times_figure(const Analysis& analysis, const ReportNumbers& numbers,
                                                 const std::filesystem::path& folder);

/// Mean noticeability by tenths of the session, what was shown and who was asked being equal. None where
/// order is not looked at.
[[nodiscard]] std::optional<Figure> order_figure(const Analysis& analysis, const ReportNumbers& numbers,
                                                 const std::filesystem::path& folder);

}  // namespace seamline::analysis
