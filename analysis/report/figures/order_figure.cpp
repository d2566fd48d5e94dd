#include "analysis/report/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/report/figures/figure_parts.h"

namespace seamline::analysis {

std::optional<Figure> order_figure(const Analysis& analysis, const ReportNumbers& numbers,
                                   const std::filesystem::path& folder) {
  const std::vector<SessionPart>& parts = numbers.order.tenths;
  if (parts.empty()) return std::nullopt;
  const TaskWords words = task_words(analysis);
  Figure figure{
      .name = "order",
      .title = words.title + " during the session",
      .caption = words.Mean +
                 " in each tenth of a participant's answers, what was shown and who "
                 "was asked being equal; bars: 95 % intervals over participants. Dashed: the mean of "
                 "all. Data: " +
                 source_text(analysis) + ".",
      .svg = folder / "order.svg"};
  std::string block = "$parts << EOD\n";
  double low = parts.front().mean, high = low, mean = 0, answers = 0;
  for (const SessionPart& part : parts) {
    block += fmt::format("{:.4g} {:.6g} {:.6g} {:.6g}\n", 50 * (part.from + part.to), part.mean,
                         part.ci95.low, part.ci95.high);
    low = std::min(low, part.ci95.low);
    high = std::max(high, part.ci95.high);
    mean += part.mean * part.answers;
    answers += part.answers;
  }
  block += "EOD\n";
  const double room = std::max(words.rated ? 0.2 : 0.05, 0.15 * (high - low));
  const PanelGrid grid = panel_grid(1, 150);
  const PlotStyle style = plot_style(0);
  const std::string script =
      block + level_axis_script(levels_drawn(analysis.data)) + margins(grid.panels.front()) +
      fmt::format(
          "unset logscale x\nset xrange [0:100]\nset xtics 0, 20, 100\nset yrange [{:.4f}:{:.4f}]\nset ytics "
          "auto\n"
          "set title \"{}\" font ',13' textcolor rgb '{}' offset 0,-0.6\n"
          "set xlabel \"share of the session (%)\" textcolor rgb '{}' offset 0,0.4\n"
          "set ylabel \"{}\" textcolor rgb '{}' offset 0.2,0\n"
          "plot {:.6g} with lines lc rgb '{}' lw 1 dt (8,5) notitle, \\\n"
          "     $parts using 1:3:(0):($4-$3) with vectors nohead lc rgb '{}' lw 1.2 notitle, \\\n"
          "     $parts using 1:2 with linespoints lc rgb '{}' lw 1.4 pt {} ps 0.5 notitle\n",
          low - room, high + room, gnuplot_text(source_text(analysis)), plot_ink, plot_ink, words.mean,
          plot_ink, mean / answers, plot_ink, style.colour, style.colour, style.point);
  draw_figure(figure.svg, grid.height_px, script, Readers::owner);
  return figure;
}

}  // namespace seamline::analysis
