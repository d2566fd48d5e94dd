#include "analysis/report/figures/figure_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace seamline::analysis {

namespace {

constexpr double octaves_apart = 2;
constexpr double share_beyond = 1.25;  ///< of a level on log2 axes
constexpr double units_beyond = 0.3;   ///< sixths of the range on linear ones

std::string tic_text(const LevelsDrawn& drawn, double level) {
  return tested_text(drawn.axis, level);
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

std::string level_tics(const LevelsDrawn& drawn, bool labelled) {
  std::string ticks;
  for (const double level : drawn.levels)
    ticks += fmt::format("{}'{}' {}", ticks.empty() ? "" : ", ", labelled ? tic_text(drawn, level) : "",
                         place_of(drawn, level));
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
      "set border 3 lc rgb '{0}' lw 1\nset tics nomirror out scale 0.6 textcolor rgb '{0}'\n"
      "{1}{2}set xrange [{3}:{4}]\n"
      "set grid ytics lc rgb '#B4B4B4' lw 0.5 dt solid\n"
      "set key textcolor rgb '{0}' Left reverse samplen 2\n",
      plot_ink, level_tics(drawn, true), is_linear(drawn.axis) ? "" : "set logscale x 2\n", number(range.low),
      number(range.high));
}

std::string axis_labels(const LevelAxis& axis, const std::string& y) {
  return fmt::format("set xlabel \"{2}\" textcolor rgb '{0}'\nset ylabel \"{1}\" textcolor rgb '{0}'\n",
                     plot_ink, y, axis_title(axis));
}

std::vector<Artifact> drawn_artifacts(const NoticeabilityData& data) {
  std::vector<Artifact> artifacts;
  for (const ArtifactScores& scores : data.artifacts)
    if (artifacts.empty() || artifacts.back() != scores.artifact) artifacts.push_back(scores.artifact);
  return artifacts;
}

PanelGrid panel_grid(std::size_t panels, int panel_height_px) {
  const std::size_t columns = panels > 1 ? 2 : 1, rows = (panels + columns - 1) / columns;
  PanelGrid grid{.width_px = columns == 1 ? 640 : 1080,
                 .height_px = 30 + panel_height_px * static_cast<int>(rows),
                 .panels = {}};
  const double width = 1.0 / static_cast<double>(columns);
  for (std::size_t i = 0; i < panels; ++i) {
    const auto column = static_cast<double>(i % columns), row = static_cast<double>(i / columns);
    const double top_px = 30 + panel_height_px * row;
    grid.panels.push_back({.left = column * width + 74.0 / grid.width_px,
                           .right = (column + 1) * width - 16.0 / grid.width_px,
                           .bottom = 1 - (top_px + panel_height_px - 76) / grid.height_px,
                           .top = 1 - (top_px + 44) / grid.height_px});
  }
  return grid;
}

std::string margins(const Panel& panel) {
  return fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
      "set tmargin at screen {:.4f}\n",
      panel.left, panel.right, panel.bottom, panel.top);
}

std::string multiplot(const Analysis& analysis) {
  return fmt::format("set multiplot title \"{}\" font ',13' textcolor rgb '{}'\n",
                     gnuplot_text(source_text(analysis)), plot_ink);
}

}  // namespace seamline::analysis
