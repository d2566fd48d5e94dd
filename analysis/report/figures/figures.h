#pragma once
#include <filesystem>
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

}  // namespace seamline::analysis
