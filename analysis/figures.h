#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/analysis.h"

namespace seamline {

/// A figure of the report.
struct Figure {
  std::string name;  ///< of the file, without `.svg`
  std::string title;
  std::string caption;
  std::filesystem::path svg;
};

/// Draws the paper's Fig. 6 (a panel an artifact, a line an object, SEM bars) and Fig. 7 (averages over
/// objects with dotted lines at 0.5 and 1.0) into `folder`, with colours that colour-blind readers can tell
/// apart (Okabe and Ito) and a shape a line.
[[nodiscard]] std::vector<Figure> draw_figures(const Analysis& analysis, const std::filesystem::path& folder);

/// The SVG of a figure as part of a page: no XML header, ids that are unique on the page, and text and axes
/// in the page's own text colour, so that it suits a light and a dark page.
[[nodiscard]] std::string inline_svg(const Figure& figure);

}  // namespace seamline
