#pragma once
#include <string>
#include <vector>

#include "analysis/report/figures/figures.h"
#include "support/files/gnuplot.h"

namespace seamline::analysis {

// What the figures of a report share. `inline_svg` replaces `plot_ink` by the page's text colour.

/// The axis under a figure: levels seen in the data, rising. One that stands apart is drawn two octaves below
/// the others, not joined to them.
struct LevelsDrawn {
  LevelAxis axis;
  std::vector<double> levels;
};
[[nodiscard]] LevelsDrawn levels_drawn(const NoticeabilityData& data);

/// Where a level is drawn, moved by a share of an octave (of a sixth of the range on linear axes) so that
/// several lines stay apart.
[[nodiscard]] double place_of(const LevelsDrawn& drawn, double level, double shift = 0);

/// What goes between two rows of a data block: a gap before a level that stands apart.
[[nodiscard]] std::string gap_before(const LevelsDrawn& drawn, double level);

/// A tic at each level, with or without its number.
[[nodiscard]] std::string level_tics(const LevelsDrawn& drawn, bool labelled);

/// Where lines leave room for the key: "right", or "left" where noticeability rises.
[[nodiscard]] const char* key_side(const LevelAxis& axis);

/// Where a label stands beside a low line across the figure, at its height `y`, clear of lines and of a level
/// that stands apart: "graph 0.004, first 0.5 left"; at the other end where noticeability rises.
[[nodiscard]] std::string beside_line(const LevelAxis& axis, double from_end, const std::string& y);

/// The ends of the axis: a little wider than what was tested.
[[nodiscard]] Interval drawn_range(const LevelsDrawn& drawn);

/// Borders, tics and the axis of levels.
[[nodiscard]] std::string level_axis_script(const LevelsDrawn& drawn);

/// "depth map width W (px)" under the axis, and `y` beside the other.
[[nodiscard]] std::string axis_labels(const LevelAxis& axis, const std::string& y);

/// The artifacts of several curves, each once, in their order: a panel each where a study has conditions.
[[nodiscard]] std::vector<Artifact> drawn_artifacts(const NoticeabilityData& data);

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

}  // namespace seamline::analysis
