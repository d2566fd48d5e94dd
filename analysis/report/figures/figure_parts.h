#pragma once
#include <string>
#include <vector>

#include "analysis/report/figures/figures.h"
#include "support/files/gnuplot.h"

namespace seamline::analysis {

// What the figures of a report share. `inline_svg` replaces `plot_ink` by the page's text colour.

/// Widths seen in the data, rising.
[[nodiscard]] std::vector<int> tested_widths(const NoticeabilityData& data);

/// A tic at each width, with or without its number.
[[nodiscard]] std::string width_tics(const std::vector<int>& widths_px, bool labelled);

/// Borders, tics and the log2 axis of widths, a little wider than what was tested.
[[nodiscard]] std::string width_axis(const std::vector<int>& widths_px);

/// "depth map width W (px)" under the axis, and `y` beside the other.
[[nodiscard]] std::string axis_labels(const std::string& y);

/// A panel in a grid of panels, in screen coordinates (0 to 1, from the bottom left).
struct Panel {
  double left = 0, right = 1, bottom = 0, top = 1;
};

/// Panels two a row (one when there is one), with room for a title above and labels beside each.
struct PanelGrid {
  int width_px = 0, height_px = 0;
  std::vector<Panel> panels;
};
[[nodiscard]] PanelGrid panel_grid(std::size_t panels, int panel_height_px);

/// `set lmargin ...` for a panel.
[[nodiscard]] std::string margins(const Panel& panel);

/// The title above a whole figure: who answered.
[[nodiscard]] std::string multiplot(const Analysis& analysis);

// Figures that may be missing have no value then.

/// Right choices against width: points by trials, fitted curve with its band, residuals below.
[[nodiscard]] std::optional<Figure> psychometric_figure(const Analysis& analysis,
                                                        const ReportNumbers& numbers,
                                                        const std::filesystem::path& folder);

/// Mean noticeability as answered and corrected for guessing.
[[nodiscard]] std::optional<Figure> guessing_figure(const Analysis& analysis,
                                                    const std::filesystem::path& folder);

/// Median time to the choice against width, right and wrong choices apart, with quartiles.
[[nodiscard]] std::optional<Figure> times_figure(const Analysis& analysis, const ReportNumbers& numbers,
                                                 const std::filesystem::path& folder);

}  // namespace seamline::analysis
