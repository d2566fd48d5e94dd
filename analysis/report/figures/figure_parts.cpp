#include "analysis/report/figures/figure_parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace seamline::analysis {

std::vector<int> tested_widths(const NoticeabilityData& data) {
  std::vector<int> widths;
  for (const ArtifactScores& scores : data.artifacts)
    widths.insert(widths.end(), scores.width_px.begin(), scores.width_px.end());
  std::sort(widths.begin(), widths.end());
  widths.erase(std::unique(widths.begin(), widths.end()), widths.end());
  return widths;
}

std::string width_tics(const std::vector<int>& widths_px, bool labelled) {
  std::string ticks;
  for (int width : widths_px)
    ticks +=
        fmt::format("{}'{}' {}", ticks.empty() ? "" : ", ", labelled ? std::to_string(width) : "", width);
  return "set xtics (" + ticks + ")\n";
}

std::string width_axis(const std::vector<int>& widths_px) {
  return fmt::format(
      "set border 3 lc rgb '{0}' lw 1\nset tics nomirror out scale 0.6 textcolor rgb '{0}'\n"
      "{1}set logscale x 2\nset xrange [{2:.4f}:{3:.4f}]\n"
      "set grid ytics lc rgb '#B4B4B4' lw 0.5 dt solid\n"
      "set key textcolor rgb '{0}' Left reverse samplen 2\n",
      plot_ink, width_tics(widths_px, true), widths_px.front() / 1.25, widths_px.back() * 1.25);
}

std::string axis_labels(const std::string& y) {
  return fmt::format(
      "set xlabel \"depth map width W (px)\" textcolor rgb '{0}'\nset ylabel \"{1}\" textcolor rgb '{0}'\n",
      plot_ink, y);
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
