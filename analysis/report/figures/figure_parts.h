#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "analysis/log_analysis/task_words.h"
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

/// A tic at each level. Every one, or every second, third ... has its number, as far as there is room on an
/// axis of `axis_px`; 0: none has.
[[nodiscard]] std::string level_tics(const LevelsDrawn& drawn, double axis_px);

/// Where lines leave room for the key: "right", or "left" where noticeability rises.
[[nodiscard]] const char* key_side(const LevelAxis& axis);

/// Where a label stands beside a low line across the figure, at its height `y`, clear of lines and of a level
/// that stands apart: "graph 0.004, first 0.5 left"; at the other end where noticeability rises.
[[nodiscard]] std::string beside_line(const LevelAxis& axis, double from_end, const std::string& y);

/// The ends of the axis: a little wider than what was tested.
[[nodiscard]] Interval drawn_range(const LevelsDrawn& drawn);

/// Borders, tics and the axis of levels.
[[nodiscard]] std::string level_axis_script(const LevelsDrawn& drawn);

/// The curves of one panel: one each, or where a study has conditions all those of an artifact.
struct PanelCurves {
  std::string title;
  std::vector<std::size_t> curves;  ///< places in `NoticeabilityData::artifacts`
};
[[nodiscard]] std::vector<PanelCurves> panels_of_curves(const NoticeabilityData& data);

/// A panel in a grid of panels, in screen coordinates (0 to 1, from the bottom left).
struct Panel {
  double left = 0, right = 1, bottom = 0, top = 1;
  bool leftmost = true, lowest = true;  ///< names its vertical axis, its horizontal one
  double width_px = 0;
};

/// Panels of `column_width_px` together, two a row (one when there is one), with room for a title above and
/// labels beside each. Panels of a row have one vertical axis.
struct PanelGrid {
  int height_px = 0;
  std::vector<Panel> panels;
};
[[nodiscard]] PanelGrid panel_grid(std::size_t panels, int panel_height_px);

/// `set lmargin ...` for a panel.
[[nodiscard]] std::string margins(const Panel& panel);

/// Margins, title and labelled axes of a panel: levels below, `y` beside. Numbers at the vertical axis only
/// where it is leftmost.
[[nodiscard]] std::string panel_frame(const Panel& panel, const LevelsDrawn& drawn, const std::string& title,
                                      const std::string& y);

inline constexpr int keyed_panel_px = 190;  ///< height of a panel with a key of three rows above the data

/// How means of answers are drawn.
struct MeansDrawn {
  TaskWords words;
  std::string axis,
      axis_below_key;  ///< gnuplot's lines for the vertical axis; the latter with room for a key
  std::string lines;   ///< begins a `plot`: dotted lines at PT and SN, or at chance
  std::string dotted;  ///< what these are, a sentence
};
/// Noticeability from 0 to 4; of a task without ratings shares from 0 to 1.
[[nodiscard]] MeansDrawn means_drawn(const Analysis& analysis);

/// The title above a whole figure: who answered.
[[nodiscard]] std::string multiplot(const Analysis& analysis);

/// How the panels of a figure of all curves look.
struct CurvePanels {
  int height_px = 0;
  std::string axis;  ///< gnuplot's lines for the vertical axis
  std::string y;     ///< what stands beside it
};
/// Draws a panel for each curve of the data, in which `plots` draws curve `i`.
void draw_curve_panels(const Analysis& analysis, const std::filesystem::path& svg, const CurvePanels& panels,
                       const std::function<std::string(const LevelsDrawn&, std::size_t i)>& plots);

}  // namespace seamline::analysis
