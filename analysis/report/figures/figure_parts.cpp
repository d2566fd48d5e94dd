#include "analysis/report/figures/figure_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/text/threshold_text.h"

namespace seamline::analysis {

namespace {

constexpr double octaves_apart = 2;
constexpr double share_beyond = 1.25;  ///< of a level on log2 axes
constexpr double units_beyond = 0.3;   ///< sixths of the range on linear ones

// Pixels of a figure of one column.
constexpr double head_px = 32, title_px = 24, tics_px = 26, axis_title_px = 26, row_gap_px = 10;
constexpr double left_px = 46, right_px = 12, column_gap_px = 16;
constexpr double digit_px = 0.64 * smallest_letters_px, label_gap_px = 7;

std::string tic_text(const LevelsDrawn& drawn, double level) {
  return tested_text(drawn.axis, level);
}

/// Every how many levels have a label, so that no two touch; 0 without an axis.
std::size_t label_stride(const LevelsDrawn& drawn, double axis_px) {
  if (!(axis_px > 0)) return 0;
  const Interval range = drawn_range(drawn);
  const auto along = [&](double at) { return is_linear(drawn.axis) ? at : std::log2(at); };
  const double px_of_x = axis_px / (along(range.high) - along(range.low));
  const auto half_px = [&](double level) {
    return digit_px / 2 * static_cast<double>(tic_text(drawn, level).size());
  };
  for (std::size_t stride = 1; stride < drawn.levels.size(); ++stride) {
    bool fits = true;
    for (std::size_t i = stride; i < drawn.levels.size(); i += stride) {
      const double one = drawn.levels[i - stride], next = drawn.levels[i];
      const double apart_px = px_of_x * (along(place_of(drawn, next)) - along(place_of(drawn, one)));
      if (apart_px < half_px(one) + half_px(next) + label_gap_px) fits = false;
    }
    if (fits) return stride;
  }
  return drawn.levels.size();
}

double smallest_on_axis(const LevelsDrawn& drawn) {
  for (const double level : drawn.levels)
    if (!stands_apart(drawn.axis, level)) return level;
  return 1;
}

}  // namespace

LevelsDrawn levels_drawn(const NoticeabilityData& data) {
  LevelsDrawn drawn{.axis = data.axis, .levels = {}};
  for (const ArtifactScores& scores : data.artifacts)
    drawn.levels.insert(drawn.levels.end(), scores.level.begin(), scores.level.end());
  std::sort(drawn.levels.begin(), drawn.levels.end());
  drawn.levels.erase(std::unique(drawn.levels.begin(), drawn.levels.end()), drawn.levels.end());
  return drawn;
}

double place_of(const LevelsDrawn& drawn, double level, double shift) {
  if (is_linear(drawn.axis)) return level + shift * drawn.axis.unit;
  if (stands_apart(drawn.axis, level)) level = smallest_on_axis(drawn) * std::exp2(-octaves_apart);
  return level * std::exp2(shift);
}

std::string gap_before(const LevelsDrawn& drawn, double level) {
  return stands_apart(drawn.axis, level) ? "\n" : "";
}

std::string level_tics(const LevelsDrawn& drawn, double axis_px) {
  const std::size_t stride = label_stride(drawn, axis_px);
  std::string ticks;
  for (std::size_t i = 0; i < drawn.levels.size(); ++i) {
    const double level = drawn.levels[i];
    const bool labelled = stride > 0 && (i % stride == 0 || stands_apart(drawn.axis, level));
    ticks += fmt::format("{}'{}' {}", ticks.empty() ? "" : ", ", labelled ? tic_text(drawn, level) : "",
                         place_of(drawn, level));
  }
  return "set xtics (" + ticks + ")\n";
}

const char* key_side(const LevelAxis& axis) {
  return axis.noticeability == Direction::increasing ? "left" : "right";
}

std::string beside_line(const LevelAxis& axis, double from_end, const std::string& y) {
  const bool rises = axis.noticeability == Direction::increasing;
  return fmt::format("graph {:g}, first {} {}", rises ? 1 - from_end : from_end, y, rises ? "right" : "left");
}

Interval drawn_range(const LevelsDrawn& drawn) {
  const double first = place_of(drawn, drawn.levels.front()), last = place_of(drawn, drawn.levels.back());
  if (!is_linear(drawn.axis)) return {.low = first / share_beyond, .high = last * share_beyond};
  return {.low = first - units_beyond * drawn.axis.unit, .high = last + units_beyond * drawn.axis.unit};
}

std::string level_axis_script(const LevelsDrawn& drawn) {
  const Interval range = drawn_range(drawn);
  const auto number = [&](double value) {
    return of_depth_widths(drawn.axis) ? fmt::format("{:.4f}", value) : fmt::format("{:.8g}", value);
  };
  return fmt::format(
      "set border 3 lc rgb '{0}' lw 1\nset tics nomirror out scale 0.5 textcolor rgb '{0}'\n"
      "{1}set xrange [{2}:{3}]\n"
      "set grid ytics lc rgb '#B4B4B4' lw 0.5 dt solid\n"
      "set key textcolor rgb '{0}' Left reverse samplen 1.5\n",
      plot_ink, is_linear(drawn.axis) ? "" : "set logscale x 2\n", number(range.low), number(range.high));
}

std::vector<PanelCurves> panels_of_curves(const NoticeabilityData& data) {
  std::vector<PanelCurves> panels;
  const bool conditions = has_conditions(data);
  for (std::size_t i = 0; i < data.artifacts.size(); ++i) {
    const ArtifactScores& scores = data.artifacts[i];
    const bool same = conditions && i > 0 && data.artifacts[i - 1].artifact == scores.artifact;
    if (!same) panels.push_back({.title = artifact_title(scores.artifact), .curves = {}});
    panels.back().curves.push_back(i);
  }
  return panels;
}

PanelGrid panel_grid(std::size_t panels, int panel_height_px) {
  const std::size_t columns = panels > 1 ? 2 : 1, rows = (panels + columns - 1) / columns;
  const double row_px = title_px + panel_height_px + tics_px + row_gap_px;
  PanelGrid grid{.height_px = static_cast<int>(head_px + row_px * static_cast<double>(rows) + axis_title_px),
                 .panels = {}};
  const double width_px =
      (column_width_px - left_px - right_px - column_gap_px * static_cast<double>(columns - 1)) /
      static_cast<double>(columns);
  for (std::size_t i = 0; i < panels; ++i) {
    const double x_px = left_px + static_cast<double>(i % columns) * (width_px + column_gap_px);
    const double y_px = head_px + static_cast<double>(i / columns) * row_px + title_px;
    grid.panels.push_back({.left = x_px / column_width_px,
                           .right = (x_px + width_px) / column_width_px,
                           .bottom = 1 - (y_px + panel_height_px) / grid.height_px,
                           .top = 1 - y_px / grid.height_px,
                           .leftmost = i % columns == 0,
                           .lowest = i + columns >= panels,
                           .width_px = width_px});
  }
  return grid;
}

std::string margins(const Panel& panel) {
  return fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
      "set tmargin at screen {:.4f}\n",
      panel.left, panel.right, panel.bottom, panel.top);
}

std::string panel_frame(const Panel& panel, const LevelsDrawn& drawn, const std::string& title,
                        const std::string& y) {
  return margins(panel) + level_tics(drawn, panel.width_px) +
         fmt::format("set title \"{}\" font ',13' textcolor rgb '{}' offset 0,-0.6\nset format y {}\n",
                     gnuplot_text(title), plot_ink, panel.leftmost ? "'%g'" : "''") +
         (panel.lowest ? fmt::format("set xlabel \"{}\" textcolor rgb '{}' offset 0,0.4\n",
                                     gnuplot_text(axis_title(drawn.axis)), plot_ink)
                       : "unset xlabel\n") +
         (panel.leftmost ? fmt::format("set ylabel \"{}\" textcolor rgb '{}' offset {},0\n", y, plot_ink,
                                       y == "mean noticeability" ? 0.2 : 1.4)
                         : "unset ylabel\n");
}

MeansDrawn means_drawn(const Analysis& analysis) {
  MeansDrawn drawn;
  drawn.words = task_words(analysis);
  const TaskWords& words = drawn.words;
  if (words.rated) {
    drawn.axis = "set ytics 0, 1, 4\nset mytics 2\nset yrange [0:4.15]\n";
    drawn.axis_below_key =
        "set ytics 0, 1, 4\nset mytics 2\nset yrange [0:5.5]\nset key maxrows 3 top right\n";
    drawn.lines = fmt::format(
        "plot 0.5 with lines lc rgb '{0}' lw 1 dt '.' notitle, 1.0 with lines lc rgb '{0}' lw 1 dt '.' "
        "notitle",
        plot_ink);
    drawn.dotted = "Dotted: 0.5 (PT) and 1.0 (SN).";
    return drawn;
  }
  drawn.axis = "set ytics 0, 0.2, 1\nset yrange [0:1.04]\n";
  drawn.axis_below_key = "set ytics 0, 0.2, 1\nset yrange [0:1.4]\nset key maxrows 3 top right\n";
  drawn.lines = fmt::format("plot {:.6g} with lines lc rgb '{}' lw 1 dt '.' notitle", words.chance, plot_ink);
  drawn.dotted = "Dotted: " + words.chance_text + ".";
  return drawn;
}

std::string multiplot(const Analysis& analysis) {
  return fmt::format("set multiplot title \"{}\" font ',{}' textcolor rgb '{}'\n",
                     gnuplot_text(source_text(analysis)), smallest_letters_px, plot_ink);
}

void draw_curve_panels(const Analysis& analysis, const std::filesystem::path& svg, const CurvePanels& panels,
                       const std::function<std::string(const LevelsDrawn&, std::size_t i)>& plots) {
  const LevelsDrawn drawn = levels_drawn(analysis.data);
  const PanelGrid grid = panel_grid(analysis.data.artifacts.size(), panels.height_px);
  std::string script = level_axis_script(drawn) + panels.axis + multiplot(analysis);
  for (std::size_t i = 0; i < grid.panels.size(); ++i) {
    const ArtifactScores& scores = analysis.data.artifacts[i];
    script +=
        panel_frame(grid.panels[i], drawn, artifact_title(scores.artifact, scores.condition), panels.y) +
        plots(drawn, i);
  }
  draw_figure(svg, grid.height_px, script + "unset multiplot\n", Readers::owner);
}

}  // namespace seamline::analysis
